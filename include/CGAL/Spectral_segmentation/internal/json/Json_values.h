// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_JSON_VALUES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_JSON_VALUES_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef nlohmann::json::value_t Json_kind;

// A value of a JSON text. The elements of an array, or the members of an object, follow it; each
// is followed by its own. Iterating over a value gives its elements or members.
struct Json_value
{
  struct Iterator
  {
    const Json_value* value;

    const Json_value& operator*() const { return *value; }
    Iterator& operator++() { value += value->size; return *this; }
    bool operator!=(const Iterator& other) const { return value != other.value; }
  };

  Json_kind kind;
  std::size_t size;        // the number of values from this one to the last one within it
  std::size_t key;         // the place of its key, if it is a member of an object
  std::uint64_t count = 0; // an unsigned number, a Boolean value, the place of a string, or the
                           // number of elements or members
  double number = 0;       // any number

  bool is_number() const
  {
    return kind == Json_kind::number_unsigned || kind == Json_kind::number_integer ||
           kind == Json_kind::number_float;
  }

  Iterator begin() const { return {this + 1}; }
  Iterator end() const { return {this + size}; }
};

// The values of a JSON text, which its parser reports one by one. They take linear time and memory
// for all texts, because nothing is looked up and no value allocates memory of its own.
class Json_values
{
  static constexpr std::size_t largest_depth_ = 10; // the JSON of a hierarchy is 5 levels deep

  std::vector<Json_value> values_;
  std::string texts_;             // the keys and strings, each with a final 0
  std::vector<std::size_t> open_; // the arrays and objects that have not ended yet
  std::size_t key_ = 0;           // the place of the last key

  bool add(Json_kind kind, std::uint64_t count = 0, double number = 0)
  {
    if (!open_.empty())
      ++values_[open_.back()].count;
    values_.push_back({kind, 1, key_, count, number});
    return true;
  }

  std::size_t add_text(const std::string& text)
  {
    const std::size_t place = texts_.size();
    texts_.append(text.c_str(), text.size() + 1);
    return place;
  }

  bool open(Json_kind kind)
  {
    if (open_.size() == largest_depth_)
      throw std::runtime_error("read_hierarchy: the JSON is nested too deep");
    add(kind);
    open_.push_back(values_.size() - 1);
    return true;
  }

  bool close()
  {
    values_[open_.back()].size = values_.size() - open_.back();
    open_.pop_back();
    return true;
  }

public:
  // Parses a text.
  explicit Json_values(std::istream& is) { nlohmann::json::sax_parse(is, this); }

  const Json_value& root() const { return values_.front(); }
  const char* key(const Json_value& value) const { return texts_.c_str() + value.key; }

  const char* string(const Json_value& value) const { return texts_.c_str() + value.count; }

  // The functions that the parser calls
  bool null() { return add(Json_kind::null); }
  bool boolean(bool value) { return add(Json_kind::boolean, value); }
  bool number_integer(std::int64_t value)
  { return add(Json_kind::number_integer, 0, static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value)
  { return add(Json_kind::number_unsigned, value, static_cast<double>(value)); }
  bool number_float(double value, const std::string&)
  { return add(Json_kind::number_float, 0, value); }
  bool string(const std::string& value) { return add(Json_kind::string, add_text(value)); }
  template <class Binary> bool binary(const Binary&) { return false; }
  bool start_object(std::size_t) { return open(Json_kind::object); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json_kind::array); }
  bool end_array() { return close(); }

  bool key(const std::string& value)
  {
    key_ = add_text(value);
    return true;
  }

  [[noreturn]] bool parse_error(std::size_t byte, const std::string&,
                                const nlohmann::json::exception& e)
  {
    if (dynamic_cast<const nlohmann::json::parse_error*>(&e) == nullptr)
      throw std::runtime_error("read_hierarchy: a number is too large");
    throw std::runtime_error("read_hierarchy: the JSON is not well-formed at byte " +
                             std::to_string(byte));
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_JSON_VALUES_H
