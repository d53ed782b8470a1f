// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Fits the numbers of `Calibrated_part_salience` to people's cuts on the Princeton Segmentation
/// Benchmark, and reports the Rand errors of runs with them; also with each category judged by
/// numbers that are fitted to the others.
///
/// By default it fits the network for boundaries to all boundaries that merging evaluates. The
/// first pass merges by the coefficients for candidates. Each further pass merges the meshes of a
/// category by the network that the boundaries of the other categories of all passes before give.
/// Meshes whose parts are known count as one more category, to which nothing is fitted by default.
///
/// For candidates, the cuts are those that a run with the numbers in the source evaluates, in
/// further passes those of runs with the numbers of the pass before.

#include "Boundary_network_fit.h"
#include "evaluation.h"
#include "evaluated_cuts.h"
#include "for_each_mesh.h"
#include "known_parts.h"
#include "method_variants.h"
#include "part_salience_fit.h"
#include "program.h"
#include "tree_errors.h"
#include "triangulations.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;
using spectral::internal::Named_factor;
using spectral::internal::named_factors;

typedef nlohmann::ordered_json Json;
typedef std::map<std::size_t, Calibrated_part_salience> Saliences; // indexed by category

struct Options
{
  std::string folder, ids = "odd", kind = "boundaries", known_parts, json, cache, table;
  std::vector<std::string> triangulations = {triangulation_names().front()};
  std::size_t threads = 1, rounds = 3, passes = 2;
  std::size_t coarse_faces =
    CGAL::Spectral_segmentation::Options().number_of_coarse_faces;
  bool leaves_one_category_out = false, leaves_factors_out = false, fits_known_parts = false;
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  app.add_option("--kind", o.kind, "what is fitted: boundaries or candidates")
    ->capture_default_str()->check(CLI::IsMember({"boundaries", "candidates"}));
  app.add_option("--known-parts", o.known_parts,
                 "also judges the files NAME.off of a folder by area; NAME.truth has the number of "
                 "the part of each triangle")
    ->check(CLI::ExistingDirectory)->type_name("DIR");
  app.add_flag("--fit-known-parts", o.fits_known_parts, "also fits to them");
  app.add_option("--table", o.table, "writes the header with the network")->type_name("OUT.h");
  app.add_option("--rounds", o.rounds,
                 "of fitting candidates again, each with more weight on the cuts that the last one "
                 "prefers")
    ->capture_default_str();
  app.add_option("--passes", o.passes, "of runs")
    ->check(CLI::Range(1, 100))->capture_default_str();
  app.add_option("--triangulation", o.triangulations, "in which the cuts are made")
    ->capture_default_str()->check(CLI::IsMember(triangulation_names()));
  app.add_option("--cache", o.cache, "folder that keeps the triangulations for other runs");
  app.add_option("--coarse-faces", o.coarse_faces,
                 "the number_of_coarse_faces of all runs; 0: the meshes themselves")
    ->capture_default_str();
  app.add_flag("--leave-one-category-out", o.leaves_one_category_out,
               "also judges each category by a fit to the others");
  app.add_flag("--leave-factors-out", o.leaves_factors_out,
               "also fits without each factor");
  app.add_option("--json", o.json, "writes all figures, of each mesh too")->type_name("OUT");
  app.add_option("--threads", o.threads,
                 "meshes at a time, each on one thread; with 1, a mesh may use all threads")
    ->check(CLI::Range(1, 1024))->capture_default_str();
}

// The category of meshes whose parts are known comes after those of the benchmark.
constexpr int first_known_id = meshes_per_category * static_cast<int>(category_names.size()) + 1;

bool has_known_parts(int id) { return id >= first_known_id; }

std::size_t category_of(int id)
{ return has_known_parts(id) ? category_names.size() : category(id); }

std::string name_of_category(std::size_t category)
{ return category < category_names.size() ? category_names[category] : "known"; }

Benchmark_mesh read_known_mesh(const std::filesystem::path& file, int id)
{
  Benchmark_mesh result{id, read_mesh(file), {}, {}};
  const std::filesystem::path truth = std::filesystem::path(file).replace_extension(".truth");
  result.people = {read_labels(truth, result.mesh.number_of_faces())};
  result.face_weights = triangle_areas(triangle_soup(result.mesh));
  return result;
}

// Returns f(mesh) of each mesh of the benchmark, then of each with known parts.
template <class Function>
auto of_each_mesh(const Options& o, const Function& f)
{
  const std::vector<int> ids = parse_ids(o.ids);
  const std::vector<std::filesystem::path> files =
    o.known_parts.empty() ? std::vector<std::filesystem::path>() : off_files(o.known_parts);
  std::vector<decltype(f(Benchmark_mesh()))> results(ids.size() + files.size());
  Progress progress(results.size());
  for_each_mesh(results.size(), o.threads, [&](std::size_t i) {
    const std::size_t k = i - ids.size();
    results[i] = f(i < ids.size()
                     ? read_benchmark_mesh(o.folder, ids[i])
                     : read_known_mesh(files[k], first_known_id + static_cast<int>(k)));
    progress.step();
  });
  return results;
}

Engine_options options_with(const Options& o, const spectral::Part_salience& salience)
{
  Engine_options result = CGAL::Spectral_segmentation::Options();
  result.part_salience = salience;
  result.number_of_coarse_faces = o.coarse_faces;
  return result;
}

// The mesh in another triangulation, with people's segmentations of it.
Benchmark_mesh triangulated_as(const std::string& triangulation, const Benchmark_mesh& original,
                               const std::filesystem::path& cache)
{
  if (is_as_is(triangulation))
    return original;
  Mesh mesh =
    retriangulated(triangulation, original.mesh, cache, std::to_string(original.id)).mesh;
  const Retriangulated_mesh back{original.mesh, nearest_faces(mesh, original.mesh)};
  Benchmark_mesh result{original.id, std::move(mesh), {}, {}};
  for (const Labels& person : original.people)
    result.people.push_back(carried_back(back, person));
  return result;
}

// Returns the cuts of each mesh in each triangulation, of runs with a salience for each category.
template <class SalienceOfCategory>
std::vector<Mesh_cuts> evaluated_cuts(const Options& o,
                                      const SalienceOfCategory& salience_of_category)
{
  const std::vector<std::vector<Mesh_cuts> > of_meshes =
    of_each_mesh(o, [&](const Benchmark_mesh& mesh) {
      std::vector<Mesh_cuts> cuts;
      const Engine_options options =
        options_with(o, salience_of_category(category_of(mesh.id)));
      if (!has_known_parts(mesh.id) || o.fits_known_parts)
        for (const std::string& triangulation : o.triangulations)
          cuts.push_back(evaluated_cuts(triangulated_as(triangulation, mesh, o.cache), options));
      return cuts;
    });
  std::vector<Mesh_cuts> result;
  for (const std::vector<Mesh_cuts>& cuts : of_meshes)
    result.insert(result.end(), cuts.begin(), cuts.end());
  return result;
}

// Returns the errors of each mesh, of runs with a salience for each category.
template <class SalienceOfCategory>
std::vector<Tree_errors> errors_with(const Options& o,
                                     const SalienceOfCategory& salience_of_category)
{
  return of_each_mesh(o, [&](const Benchmark_mesh& mesh) {
    const Engine_options options = options_with(o, salience_of_category(category_of(mesh.id)));
    return tree_errors(mesh, method_with("fitted", options, Execution::PARALLEL));
  });
}

Part_salience_fit fit(const Options& o, const std::vector<Mesh_cuts>& cuts)
{
  if (o.kind == "candidates")
    return fit_part_salience(cuts, o.rounds);
  Part_salience_fit result;
  const Boundary_rows rows = boundary_rows(cuts);
  std::tie(result.salience.boundary_network, result.loss) = Boundary_network_fit(rows)();
  return result;
}

// Returns for each category the fit to all others.
Saliences fits_to_others(const Options& o, const std::vector<Mesh_cuts>& meshes)
{
  std::set<std::size_t> categories;
  for (int id : parse_ids(o.ids))
    categories.insert(category_of(id));
  if (!o.known_parts.empty())
    categories.insert(category_names.size());
  if (categories.size() < 2)
    throw std::invalid_argument("one category cannot be left out of one");
  const std::vector<std::size_t> left_out(categories.begin(), categories.end());
  std::vector<Calibrated_part_salience> saliences(left_out.size());
  for_each_mesh(left_out.size(), o.threads, [&](std::size_t i) {
    std::vector<Mesh_cuts> others;
    for (const Mesh_cuts& other : meshes)
      if (category_of(other.id) != left_out[i])
        others.push_back(other);
    saliences[i] = fit(o, others).salience;
  });
  Saliences result;
  for (std::size_t i = 0; i < left_out.size(); ++i)
    result[left_out[i]] = saliences[i];
  return result;
}

// Returns the cuts as if a factor were 0 at all of them, so that a fit does not use it.
std::vector<Mesh_cuts> without_factor(std::vector<Mesh_cuts> meshes,
                                      const Named_factor& factor)
{
  for (Mesh_cuts& mesh : meshes)
    for (Cut_group& group : mesh.groups)
      for (Cut_sample& cut : group.cuts)
        cut.factors.*factor.value = 0;
  return meshes;
}

// Prints the gain of each factor: the errors without it against the errors with all factors.
void print_factors(const Options& o, const std::vector<Mesh_cuts>& cuts,
                   const std::vector<Tree_errors>& with_all, Json& json)
{
  const std::size_t best_with_all = best_threshold(mean_tree_errors(with_all));
  std::printf("\nLeft out; change of\nRand error%22s%21s%21s%21s\n", "default",
              "best threshold", "k", "tree");
  for (const Named_factor& factor : named_factors) {
    const Calibrated_part_salience salience = fit(o, without_factor(cuts, factor)).salience;
    const std::vector<Tree_errors> without =
      errors_with(o, [&](std::size_t) { return salience; });
    const std::size_t best = best_threshold(mean_tree_errors(without));
    const auto change = [&](const auto& of_without, const auto& of_all) {
      const Paired_difference d =
        paired_difference(values_of(without, of_without), values_of(with_all, of_all));
      std::printf("   %+.4f +- %.4f", d.mean, d.standard_error);
    };
    std::printf("%-28s", factor.name);
    change(&Tree_errors::by_default, &Tree_errors::by_default);
    change([=](const Tree_errors& e) { return e.automatic[best]; },
           [=](const Tree_errors& e) { return e.automatic[best_with_all]; });
    change(&Tree_errors::k, &Tree_errors::k);
    change(&Tree_errors::best, &Tree_errors::best);
    std::printf("\n");
    std::fflush(stdout);
    json[factor.name] = json_of(mean_tree_errors(without));
  }
}

void print_candidates(const Part_salience_fit& fit)
{
  std::printf("  double constant = %.3f;\n", fit.salience.constant);
  for (const Fitted_factor& f : fitted_factors)
    std::printf("  double %s = %.3f;\n", f.name, fit.salience.*f.coefficient);
}

std::map<std::size_t, std::vector<Tree_errors> >
by_category(const std::vector<Tree_errors>& meshes)
{
  std::map<std::size_t, std::vector<Tree_errors> > result;
  for (const Tree_errors& mesh : meshes)
    result[category_of(mesh.id)].push_back(mesh);
  return result;
}

void print_line(const std::string& name, const std::vector<Tree_errors>& meshes,
                std::size_t threshold)
{
  const Tree_errors mean = mean_tree_errors(meshes);
  std::printf("%-10s %6zu %8.4f %8.4f %8.4f %8.4f\n", name.c_str(), meshes.size(), mean.people,
              mean.automatic[threshold], mean.k, mean.best);
}

std::vector<Tree_errors> of_benchmark(std::vector<Tree_errors> meshes)
{
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(), [](const Tree_errors& e)
                              { return has_known_parts(e.id); }), meshes.end());
  return meshes;
}

// Returns the mean errors, in which meshes with known parts count as much as the benchmark.
Tree_errors mean_of_grounds(const std::vector<Tree_errors>& meshes)
{
  std::vector<Tree_errors> grounds = {mean_tree_errors(of_benchmark(meshes))};
  std::map<std::size_t, std::vector<Tree_errors> > categories = by_category(meshes);
  if (categories.count(category_names.size()) != 0)
    grounds.push_back(mean_tree_errors(categories[category_names.size()]));
  return mean_tree_errors(grounds);
}

void print(const char* title, const std::vector<Tree_errors>& meshes)
{
  const Tree_errors mean = mean_of_grounds(meshes);
  const std::size_t best = best_threshold(mean);
  std::printf("\n%s\nthreshold     auto\n", title);
  for (std::size_t t = 0; t < mean.automatic.size(); ++t)
    std::printf("%9.2f %8.4f%s\n", tried_thresholds()[t], mean.automatic[t],
                t == best ? "  least" : "");
  std::printf("  default %8.4f\n", mean.by_default);
  std::printf("\nRand error meshes   people  auto%.2f       k     tree\n",
              tried_thresholds()[best]);
  for (const auto& [category, of_category] : by_category(meshes))
    print_line(name_of_category(category), of_category, best);
  print_line("benchmark", of_benchmark(meshes), best);
  std::fflush(stdout);
}

Json json_of(const std::vector<Tree_errors>& meshes)
{
  const Tree_errors mean = mean_tree_errors(meshes);
  Json json = json_of(mean);
  json["best_threshold"] = tried_thresholds()[best_threshold(mean)];
  for (const Tree_errors& mesh : meshes)
    json["meshes"][std::to_string(mesh.id)] = json_of(mesh);
  return json;
}

// Returns numbers as an initializer of an array.
std::string in_braces(const Boundary_network::Inputs& numbers)
{
  std::string result = "{{";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.5f", i == 0 ? "" : i % 7 == 0 ? ",\n     " : ", ",
                  numbers[i]);
    result += text;
  }
  return result + "}}";
}

void write_table(const std::string& file, const Boundary_network& network)
{
  std::ofstream out(file);
  char constant[32];
  const auto fixed = [&](double number) {
    std::snprintf(constant, sizeof constant, "%.5f", number);
    return constant;
  };
  const std::string guard =
    "CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CALIBRATED_BOUNDARY_NETWORK_H";
  out << "// Copyright (c) 2026  The Spectral_segmentation authors.\n"
         "// SPDX-License-Identifier: GPL-3.0-or-later\n\n"
         "#ifndef " << guard << "\n#define " << guard << "\n\n"
         "#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>\n\n"
         "namespace CGAL::Spectral_segmentation::internal {\n\n"
         "// benchmark/fit_part_salience --table writes this file.\n"
         "constexpr Boundary_network calibrated_boundary_network = {\n"
         "  // means and standard deviations of the factors\n"
         "    " << in_braces(network.means) << ",\n    " << in_braces(network.deviations) << ",\n"
         "  // the linear part\n"
         "  " << fixed(network.constant) << ",\n    " << in_braces(network.weights) << ",\n"
         "  // the units\n"
         "  {{\n";
  for (const Boundary_network::Unit& unit : network.units) {
    out << "  {" << fixed(unit.constant) << ",\n    " << in_braces(unit.weights) << ",\n   ";
    out << fixed(unit.output) << "},\n";
  }
  out << "  }}};\n\n} // namespace CGAL::Spectral_segmentation::internal\n\n#endif // " << guard
      << "\n";
  if (!out.flush())
    throw std::runtime_error("cannot write " + file);
}

// Prints the mean change of the logit if a factor grows by one standard deviation.
void print_effects(const Boundary_network& network, const Boundary_rows& rows)
{
  std::printf("mean change of the logit for one standard deviation\n");
  for (std::size_t i = 0; i < named_factors.size(); ++i) {
    double sum = 0;
    for (std::size_t r = 0; r < rows.factors.size(); ++r) {
      spectral::Salience_factors more = rows.factors[r], less = more;
      more.*named_factors[i].value += network.deviations[i] / 2;
      less.*named_factors[i].value -= network.deviations[i] / 2;
      sum += rows.weights[static_cast<Eigen::Index>(r)] *
             (network.logit(more) - network.logit(less));
    }
    std::printf("%-28s %+.2f\n", named_factors[i].name, sum);
  }
}

// Returns the cuts of all passes to which the boundaries are fitted.
std::vector<Mesh_cuts> boundaries_of_passes(const Options& o)
{
  std::vector<Mesh_cuts> cuts = evaluated_cuts(o, [](std::size_t) {
    return [](Salience_factors factors) {
      factors.is_boundary = false;
      return Calibrated_part_salience()(factors);
    };
  });
  for (std::size_t pass = 1; pass < o.passes; ++pass) {
    const Saliences saliences = fits_to_others(o, cuts);
    const std::vector<Mesh_cuts> more =
      evaluated_cuts(o, [&](std::size_t category) { return saliences.at(category); });
    cuts.insert(cuts.end(), more.begin(), more.end());
  }
  return cuts;
}

// Returns the cuts of the last pass.
std::vector<Mesh_cuts> candidates_of_passes(const Options& o)
{
  Calibrated_part_salience salience;
  std::vector<Mesh_cuts> cuts;
  for (std::size_t pass = 0; pass < o.passes; ++pass) {
    if (pass > 0)
      salience = fit(o, cuts).salience;
    cuts = evaluated_cuts(o, [&](std::size_t) { return salience; });
  }
  return cuts;
}

void run(const Options& o)
{
  const bool fits_boundaries = o.kind == "boundaries";
  const std::vector<Mesh_cuts> cuts = fits_boundaries ? boundaries_of_passes(o)
                                                      : candidates_of_passes(o);
  const Part_salience_fit fit_to_all = fit(o, cuts);
  std::printf("%zu cuts of %zu runs, loss %.5f\n\n", number_of_cuts(cuts), cuts.size(),
              fit_to_all.loss);
  if (fits_boundaries)
    print_effects(fit_to_all.salience.boundary_network, boundary_rows(cuts));
  else
    print_candidates(fit_to_all);
  if (!o.table.empty())
    write_table(o.table, fit_to_all.salience.boundary_network);
  const std::vector<Tree_errors> errors =
    errors_with(o, [&](std::size_t) { return fit_to_all.salience; });
  print("Fitted to all meshes", errors);

  Json json = {{"cuts", number_of_cuts(cuts)},
               {"loss", fit_to_all.loss},
               {"thresholds", tried_thresholds()},
               {"fitted_to_all", json_of(errors)}};
  if (o.leaves_one_category_out) {
    const Saliences saliences = fits_to_others(o, cuts);
    const std::vector<Tree_errors> of_left_out =
      errors_with(o, [&](std::size_t category) { return saliences.at(category); });
    print("Each category by a fit to the others", of_left_out);
    json["fitted_to_others"] = json_of(of_left_out);
  }
  if (o.leaves_factors_out)
    print_factors(o, cuts, errors, json["without_factors"]);
  write_json(o.json, json);
}

int main(int argc, char** argv)
{
  return run_program("fit_part_salience",
                     "Fits the calibrated salience to people's cuts on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
