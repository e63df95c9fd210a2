#pragma once

namespace studies {

/// Least-squares line y = at(x) through weighted points.
class LineFit {
public:
  void add(double x, double y, double weight) {
    sum_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
  }
  double slope() const { return (sum_ * xy_ - x_ * y_) / (sum_ * xx_ - x_ * x_); }
  double at(double x) const { return y_ / sum_ + slope() * (x - x_ / sum_); }
  /// Where the line is at a height y.
  double where(double y) const { return x_ / sum_ + (y - y_ / sum_) / slope(); }

private:
  double sum_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

} // namespace studies
