#include "studies/motion/stability/stability_figure.hpp"

#include "studies/runner/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace studies {
namespace {

constexpr double lowest = 1e-16; // where what is zero to round-off is drawn

std::string drawn(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", std::max(std::abs(value), lowest)) : "";
}

/// "BCC" of "BCC, 1e-06 of a cell".
std::string lattice_of(const TrialRow& row) {
  return row.name.substr(0, row.name.find(','));
}

} // namespace

std::string jitter_csv(const std::vector<TrialRow>& rows) {
  std::map<std::string, std::vector<double>> last; // what the original says at the largest jitter it answers
  for (const TrialRow& row : rows)
    if (row.group == "Jittered lattices" && row.theirs && !row.theirs->plotted.empty())
      last[lattice_of(row)] = row.theirs->plotted;
  std::string text = to_csv({"lattice", "jitter", "ours", "original"});
  for (const TrialRow& row : rows) {
    if (row.group != "Jittered lattices" || row.ours.plotted.empty())
      continue;
    std::string original;
    if (row.theirs && !row.theirs->plotted.empty() && row.theirs->plotted[0] < last[lattice_of(row)][0])
      original = drawn(row.theirs->plotted[1] / last[lattice_of(row)][1] - 1);
    text += to_csv({lattice_of(row), fmt::format("{:g}", row.ours.plotted[0]), drawn(row.ours.plotted[1]), original});
  }
  return text;
}

std::string passivity_csv(const std::vector<TrialRow>& rows) {
  std::map<double, std::array<std::string, 5>> by_ratio;
  for (const TrialRow& row : rows) {
    if (row.ours.plotted.empty())
      continue;
    const auto negative = [](double least) { return drawn(std::min(least, 0.0)); };
    if (row.group == "Resistance to motion") {
      auto& fields = by_ratio[row.ours.plotted[0]];
      fields[0] = drawn(row.ours.plotted[2]);
      fields[1] = negative(row.ours.plotted[1]);
      if (row.theirs && row.theirs->plotted.size() == 3) {
        fields[2] = drawn(row.theirs->plotted[2]);
        fields[3] = negative(row.theirs->plotted[1]);
      }
    } else if (row.group == "Energy of a coupled run") {
      by_ratio[row.ours.plotted[0]][4] = drawn(row.ours.plotted[1]);
    }
  }
  std::string text = to_csv({"size_ratio", "asymmetry", "negative_eigenvalue", "original_asymmetry",
                             "original_negative_eigenvalue", "energy_missing"});
  for (const auto& [ratio, f] : by_ratio)
    text += to_csv({fmt::format("{:g}", ratio), f[0], f[1], f[2], f[3], f[4]});
  return text;
}

const char* const stability_figure = R"gnuplot(set logscale xy
set format "10^{%T}"
set xlabel "jitter / cell"
set ylabel "|change of k| / k"
set xrange [3e-16:3e-6]
set yrange [3e-17:10]
of(name, column) = strcol(1) eq name ? column : 1/0
plot 1e-7 + 20 * x with lines dt 2 lc rgb "#888888" title "bound", \
     "jitter.csv" skip 1 using 2:(of("simple cubic", $3)) with points pt 7 lc rgb "#1f5fa8" title "simple cubic", \
     "jitter.csv" skip 1 using 2:(of("BCC", $3)) with points pt 5 ps 0.8 lc rgb "#1f5fa8" title "BCC", \
     "jitter.csv" skip 1 using 2:(of("FCC", $3)) with points pt 9 lc rgb "#1f5fa8" title "FCC", \
     "jitter.csv" skip 1 using 2:(of("simple cubic", $4)) with points pt 6 lc rgb "#c0504d" title "YADE, simple cubic", \
     "jitter.csv" skip 1 using 2:(of("BCC", $4)) with points pt 4 ps 0.8 lc rgb "#c0504d" title "YADE, BCC", \
     "jitter.csv" skip 1 using 2:(of("FCC", $4)) with points pt 8 lc rgb "#c0504d" title "YADE, FCC"
set xlabel "size ratio"
set ylabel "share"
set format x "%g"
set xrange [0.8:25]
set xtics (1, 5, 20)
plot "passivity.csv" skip 1 using 1:2 with linespoints pt 7 lc rgb "#1f5fa8" title "asymmetry", \
     "passivity.csv" skip 1 using 1:3 with linespoints pt 5 ps 0.8 lc rgb "#1f5fa8" title "negative eigenvalue", \
     "passivity.csv" skip 1 using 1:4 with linespoints pt 6 lc rgb "#c0504d" title "YADE, asymmetry", \
     "passivity.csv" skip 1 using 1:5 with linespoints pt 4 ps 0.8 lc rgb "#c0504d" title "YADE, negative eigenvalue", \
     "passivity.csv" skip 1 using 1:6 with linespoints pt 9 lc rgb "#4f8f4f" title "energy balance"
)gnuplot";

} // namespace studies
