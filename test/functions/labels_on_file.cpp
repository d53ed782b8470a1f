// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

// Compares the labels of some meshes with those in labels/, so that no change of them goes
// unnoticed. After a change that is meant, write them anew:
//
//   export SPECTRAL_SEGMENTATION_WRITE_LABELS=test/labels
//   build-test/test/unit_tests --run_test=labels_on_file
//
// Those of the method of the paper were recorded when there was no other method.
BOOST_AUTO_TEST_SUITE(labels_on_file)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;

namespace {

// Writes a line with the runs of equal labels, as LABELxNUMBER.
void write(const std::string& path, const Labels& labels)
{
  std::ofstream file(path);
  for (std::size_t begin = 0, end = 0; begin < labels.size(); begin = end) {
    while (end < labels.size() && labels[end] == labels[begin])
      ++end;
    file << labels[begin] << 'x' << end - begin << ' ';
  }
  file << '\n';
  if (!file.flush())
    throw std::runtime_error("cannot write " + path);
}

Labels read_labels(const std::string& path)
{
  std::ifstream file(path);
  Labels labels;
  std::size_t label, number;
  char x;
  while (file >> label >> x >> number)
    labels.insert(labels.end(), number, label);
  if (!file.eof() || labels.empty())
    throw std::runtime_error("cannot read " + path);
  return labels;
}

std::string first_differences(const Labels& labels, const Labels& expected)
{
  std::ostringstream text;
  std::size_t number = 0;
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (labels[f] != expected[f] && ++number <= 10)
      text << "face " << f << ": " << labels[f] << ", on file " << expected[f] << "; ";
  text << number << " of " << labels.size() << " faces differ, Rand index "
       << rand_index(labels, expected);
  return text.str();
}

template <class NamedParameters>
void check(const std::string& name, const std::string& run, const NamedParameters& np)
{
  const std::string file = "/" + name + "." + run + ".seg";
  const Labels labels = labels_of(read(name + ".off"), np);
  if (const char* directory = std::getenv("SPECTRAL_SEGMENTATION_WRITE_LABELS")) {
    write(directory + file, labels);
    return;
  }
  const Labels expected = read_labels(SPECTRAL_SEGMENTATION_TEST_LABELS_DIR + file);
  BOOST_TEST_CONTEXT(file) {
    BOOST_TEST_REQUIRE(labels.size() == expected.size());
    BOOST_TEST((labels == expected), first_differences(labels, expected));
  }
}

const double infinity = std::numeric_limits<double>::infinity();
const char* const meshes[] = {"elephant", "hand", "pig", "bones", "cactus", "dino", "tripod",
                              "blobby_3cc"};

} // namespace

BOOST_AUTO_TEST_CASE(default_method)
{
  for (const char* name : meshes)
    check(name, "default", parameters::default_values());
}

BOOST_AUTO_TEST_CASE(default_method_with_other_values)
{
  const auto np = parameters::default_values();
  check("elephant", "default_40", np.maximum_number_of_segments(40).salience_threshold(-infinity));
  check("cactus", "default_seed", np.random_seed(3).number_of_smoothing_iterations(2));
}

BOOST_AUTO_TEST_CASE(method_of_the_paper)
{
  for (const char* name : meshes)
    check(name, "paper", parameters::zhang_liu_2005().salience_threshold(0.54));
}

BOOST_AUTO_TEST_CASE(method_of_the_paper_with_other_values)
{
  const auto paper = parameters::zhang_liu_2005();
  for (const char* name : {"elephant", "tripod", "blobby_3cc"})
    check(name, "paper_12", paper.maximum_number_of_segments(12).salience_threshold(-infinity));
  check("cactus", "paper_without_minimum", paper.minimum_segment_size(0).salience_threshold(0.4));
  const auto weights = paper.salience_weights(0.2, 0.3, 0.5).salience_threshold(0.54);
  check("dino", "paper_weights", weights);
  check("dino", "paper_weights_seed", weights.random_seed(3));
}

BOOST_AUTO_TEST_SUITE_END()
