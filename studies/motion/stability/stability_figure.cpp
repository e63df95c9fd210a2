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

namespace {

/// One curve of a plot.
struct Curve {
  const char* file;
  std::string column; // as gnuplot reads it
  const char* look;
  std::string title;
  std::size_t field; // of the file, counted from 1, that must not be empty in all rows
  std::string first; // what the first field of the row must be; anything when empty
};

bool there_is_some(const std::string& csv, const Curve& curve) {
  const auto records = parse_csv(csv).records;
  return std::any_of(records.begin() + 1, records.end(), [&](const CsvRecord& record) {
    return !record[curve.field - 1].empty() && (curve.first.empty() || record[0] == curve.first);
  });
}

std::string plot(const std::string& csv, const std::string& first, const std::vector<Curve>& curves) {
  std::string text = first;
  for (const Curve& curve : curves)
    if (there_is_some(csv, curve))
      text += fmt::format("{}\"{}\" skip 1 using {} with {} title \"{}\"", text.empty() ? "plot " : ", \\\n     ",
                          curve.file, curve.column, curve.look, curve.title);
  return text.empty() ? text : text + "\n";
}

constexpr const char* ours[] = {"points pt 7 lc rgb \"#1f5fa8\"", "points pt 5 ps 0.8 lc rgb \"#1f5fa8\"",
                                "points pt 9 lc rgb \"#1f5fa8\"", "points pt 13 lc rgb \"#1f5fa8\""};
constexpr const char* original[] = {"points pt 6 lc rgb \"#c0504d\"", "points pt 4 ps 0.8 lc rgb \"#c0504d\"",
                                    "points pt 8 lc rgb \"#c0504d\"", "points pt 12 lc rgb \"#c0504d\""};

} // namespace

std::string stability_figure(const std::vector<TrialRow>& rows) {
  std::vector<Curve> jitters;
  const char* const lattices[] = {"simple cubic", "BCC", "FCC", "nine spheres"};
  for (const std::size_t field : {3u, 4u})
    for (std::size_t n = 0; n < std::size(lattices); ++n)
      jitters.push_back({"jitter.csv", fmt::format("2:(of(\"{}\", ${}))", lattices[n], field),
                         field == 3 ? ours[n] : original[n],
                         fmt::format("{}{}", field == 3 ? "" : "YADE, ", lattices[n]), field, lattices[n]});
  const auto against_ratio = [](std::size_t field, const char* look, const char* title) {
    return Curve{"passivity.csv", fmt::format("1:{}", field), look, title, field, ""};
  };
  return std::string(R"gnuplot(set bmargin 10
set key at graph 0.5, graph -0.27 maxcols 2 maxrows 5 width -3
set logscale xy
set format "10^{%T}"
set xlabel "jitter / cell"
set ylabel "|change of k| / k"
set xrange [3e-16:3e-6]
set xtics 1e-15, 1e3
set yrange [3e-17:10]
of(name, column) = strcol(1) eq name ? column : 1/0
)gnuplot") +
         plot(jitter_csv(rows), "plot 1e-7 + 20 * x with lines dt 2 lc rgb \"#888888\" title \"bound\"", jitters) +
         R"gnuplot(set xlabel "size ratio"
set ylabel "share"
set format x "%g"
set xrange [0.8:25]
set xtics (1, 5, 20)
)gnuplot" +
         plot(passivity_csv(rows), "",
              {against_ratio(2, "linespoints pt 7 lc rgb \"#1f5fa8\"", "asymmetry"),
               against_ratio(3, "linespoints pt 5 ps 0.8 lc rgb \"#1f5fa8\"", "negative eigenvalue"),
               against_ratio(4, "linespoints pt 6 lc rgb \"#c0504d\"", "YADE, asymmetry"),
               against_ratio(5, "linespoints pt 4 ps 0.8 lc rgb \"#c0504d\"", "YADE, negative eigenvalue"),
               against_ratio(6, "linespoints pt 9 lc rgb \"#4f8f4f\"", "energy balance")});
}

} // namespace studies
