// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/complete_hierarchy.h>

#include <cmath>
#include <cstddef>
#include <istream>
#include <iterator>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {

constexpr const char* first_word_of_hierarchy = "CGAL_Spectral_segmentation_hierarchy_1";

// Writes words, each after a space. Numbers have all their digits, whatever the locale.
class Word_writer
{
  std::ostringstream out_;

public:
  Word_writer()
  {
    out_.imbue(std::locale::classic());
    out_.precision(std::numeric_limits<double>::max_digits10);
  }

  template <class Value>
  void operator()(const Value& value) { out_ << ' ' << value; }

  template <class Value>
  void operator()(const std::vector<Value>& values)
  {
    (*this)(values.size());
    for (const Value& value : values)
      (*this)(value);
  }

  void end_line() { out_ << '\n'; }
  std::string text() const { return out_.str(); }
};

// Reads words, and throws `std::runtime_error` if one is not as expected.
class Word_reader
{
  std::istringstream in_;

public:
  explicit Word_reader(std::istream& is)
    : in_(std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()))
  { in_.imbue(std::locale::classic()); }

  std::string word()
  {
    std::string result;
    require_in_file(static_cast<bool>(in_ >> result), "the text ends too early");
    return result;
  }

  std::size_t count(std::size_t largest = unlimited)
  {
    std::size_t result = 0;
    require_in_file((in_ >> std::ws).peek() != '-' && in_ >> result && result <= largest,
                    "a number is not an integer in its range");
    return result;
  }

  double number()
  {
    const std::string text = word();
    if (text == "inf" || text == "-inf")
      return text == "inf" ? HUGE_VAL : -HUGE_VAL;
    if (text == "nan" || text == "-nan")
      return std::numeric_limits<double>::quiet_NaN();
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double result = 0;
    require_in_file(in >> result && in.eof(), "a word is not a number");
    return result;
  }

  template <class Value>
  std::vector<Value> counts()
  {
    std::vector<Value> result;
    for (std::size_t n = count(); n > 0; --n)
      result.push_back(static_cast<Value>(count((std::numeric_limits<Value>::max)())));
    return result;
  }
};

inline void write_node(Word_writer& write, const Cut_node& node)
{
  write(static_cast<int>(node.cut_state));
  write(node.area);
  write(node.salience);
  write(node.factors.is_boundary);
  for (const auto& factor : named_factors)
    write(node.factors.*factor.value);
  if (!node.is_leaf())
    for (std::size_t child : node.children)
      write(child);
  write.end_line();
}

inline Cut_node read_node(Word_reader& read)
{
  Cut_node result;
  result.cut_state = static_cast<Cut_state>(read.count(static_cast<std::size_t>(Cut_state::CUT)));
  result.area = read.number();
  result.salience = read.number();
  result.factors.is_boundary = read.count(1) == 1;
  for (const auto& factor : named_factors)
    result.factors.*factor.value = read.number();
  if (result.cut_state == Cut_state::CUT)
    for (std::size_t& child : result.children)
      child = read.count();
  return result;
}

} // namespace internal
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

writes a hierarchy as text, which `read_hierarchy()` reads. It needs neither the mesh nor the run.

Numbers are written with all their digits. The time is linear in the size of the text, which is
about 3 bytes for each face. The arrangement of the text may change with the first number of the
version.

\param os the stream
\param hierarchy the hierarchy

\throws std::runtime_error if the stream fails
*/
inline void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy)
{
  const internal::Cut_hierarchy& cuts = internal::Hierarchy_access::cuts(hierarchy);
  internal::Word_writer write;
  write(cuts.number_of_roots);
  write(internal::Hierarchy_access::maximum_number_of_segments(hierarchy) + 1); // 0 is no limit
  write(hierarchy.salience_threshold());
  write(cuts.is_monotonic);
  write(cuts.has_all_cuts);
  write(cuts.nodes.size());
  write.end_line();
  for (const internal::Cut_node& node : cuts.nodes)
    internal::write_node(write, node);
  write(cuts.cut_order);
  write.end_line();
  write(cuts.leaf);
  if (!(os << internal::first_word_of_hierarchy << write.text() << '\n'))
    throw std::runtime_error("write_hierarchy: the stream cannot be written");
}

/*!
\ingroup PkgSpectralSegmentationRef

reads a hierarchy that `write_hierarchy()` has written. It has the same nodes, and gives the same
labels.

The input is validated completely: every text gives either a usable hierarchy or an exception. The
time and the memory are linear in the size of the text. The stream is read to its end.

\throws std::runtime_error with an error message, if the text is not well-formed, contradicts
  itself, or has another version
*/
inline Segmentation_hierarchy read_hierarchy(std::istream& is)
{
  internal::Word_reader read(is);
  internal::require_in_file(read.word() == internal::first_word_of_hierarchy,
                            "this is not a hierarchy of this version");
  internal::Cut_hierarchy cuts;
  cuts.number_of_roots = read.count();
  const std::size_t most = read.count() - 1;
  const double threshold = read.number();
  cuts.is_monotonic = read.count(1) == 1;
  cuts.has_all_cuts = read.count(1) == 1;
  for (std::size_t n = read.count(); n > 0; --n)
    cuts.nodes.push_back(internal::read_node(read));
  cuts.cut_order = read.counts<std::size_t>();
  cuts.leaf = read.counts<internal::Index>();
  internal::complete_hierarchy(cuts);
  internal::require_in_file(!std::isnan(threshold), "the threshold is not a number");
  return Segmentation_hierarchy(std::move(cuts), most, threshold);
}

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_H
