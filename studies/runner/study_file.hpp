#pragma once

#include "studies/runner/budget.hpp"
#include "studies/runner/compare.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace studies {

/// What the literature reports for a method on a case, printed beside ours.
struct PublishedFigure {
  std::string method;
  std::optional<double> unknowns;
  std::optional<double> cpu_seconds;

  bool operator==(const PublishedFigure&) const = default;
};

struct StudyCase {
  std::string id;                         // letters, digits, _ and -: a file name
  std::string label;                      // for tables
  std::string toml;                       // the question as read_case reads it, file names absolute
  std::string place;                      // file:line it was written at
  std::vector<std::string> methods;       // of the study's, which to ask
  std::vector<std::string> quick_methods; // of those, which to ask in the quick plan
  std::vector<PublishedFigure> published;
  std::string curve = {};                                     // on which curve it is a point, see Curve; empty: on none
  Budget budget = {};                                         // of each of its runs
  std::map<std::string, std::vector<double>> mesh_sizes = {}; // by method, coarse to fine: instead of the method's
};

struct StudyMethod {
  std::string name;
  std::vector<double> mesh_sizes;       // coarse to fine
  std::vector<double> quick_mesh_sizes; // coarse to fine
  int ranks = 1;                        // processes that share a run, by MPI
  bool may_fail = false;                // a peer whose failures are a finding, and not ours
};

/// Asks for tables of how cost grows with the number of spheres.
struct Scaling {
  std::string compared_with; // method whose cost is divided by that of each other; empty: none
  std::string unit_stage;    // stage by whose CPU seconds the whole is divided; empty: none

  bool operator==(const Scaling&) const = default;
};

/// Asks for permeability against porosity: one table, and plots, for each name that cases give as their curve.
struct Curve {
  std::vector<std::string> lines; // methods drawn as lines, as formulas are
  std::string compared_with;      // method over whose permeability that of all is drawn too; empty: none

  bool operator==(const Curve&) const = default;
};

/// Asks how cheap each method is at being within these relative errors of the permeability, falling.
struct Accuracy {
  std::vector<double> levels;

  bool operator==(const Accuracy&) const = default;
};

/// Where methods are looked at one by one.
enum class PlaceKind { pores, spheres, throats };

/// One question, asked of several methods on several cases.
struct Study {
  std::string name;             // of its folder
  std::filesystem::path folder; // of its study.toml; empty for a study that has none
  std::string title;
  std::string question;
  std::string reference;        // method all others are compared with
  std::string published_source; // of the published figures; empty without any
  Tolerance tolerance;
  bool samples = false; // of pores and throats: whether methods give pressures at PFV's pores and along lines, and
                        // fluxes through its throats
  std::optional<Scaling> scaling;
  std::optional<Curve> curve = {};
  std::optional<Accuracy> accuracy = {};
  std::vector<PlaceKind> places = {}; // to be reported one by one; any asks for samples
  std::vector<StudyMethod> methods;   // in the order of the tables
  std::vector<StudyCase> cases;
};

/// Reads a study.toml; the form is described in studies/README.md. Throws pfv::InputError led by file:line, naming the
/// valid keys or values, for anything unknown, missing or out of range. The questions themselves are read later.
Study read_study(const std::filesystem::path& file);

} // namespace studies
