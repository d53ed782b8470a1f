// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_TEXT_SCANNER_H
#define SEGMENT_MESH_MESH_FILE_TEXT_SCANNER_H

#include "decimal_numbers.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace mesh_file {

// Returns a word of a file for an error message: short and printable.
inline std::string in_quotes(std::string_view word, std::size_t longest = 24)
{
  std::string result(word.substr(0, longest));
  for (char& c : result)
    if (c < ' ' || c > '~')
      c = '?';
  return "'" + result + (word.size() > longest ? "...'" : "'");
}

// Words and numbers of a text. A line ends with LF, CR LF or CR, and a backslash before its end
// continues it. A comment goes from # to the end of the line. All functions throw
// `std::runtime_error` with the line and the word at fault.
class Text_scanner
{
  const char* begin_;
  const char* position_;
  const char* end_;

  static bool is_end_of_line(char c) { return c == '\n' || c == '\r'; }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_space(char c) { return is_blank(c) || is_end_of_line(c); }

  bool is_continuation(const char* p) const
  { return *p == '\\' && end_ - p > 1 && is_end_of_line(p[1]); }

  void skip_end_of_line()
  {
    if (*position_++ == '\r' && position_ != end_ && *position_ == '\n')
      ++position_;
  }

  void skip_to_end_of_line()
  {
    while (position_ != end_ && !is_end_of_line(*position_))
      ++position_;
  }

  bool is_after_word(const char* p) const
  { return p == end_ || is_space(*p) || *p == '#' || is_continuation(p); }

  // Returns the begin of a number after its plus sign, if it has one and no minus sign follows.
  const char* after_plus() const
  {
    const bool is_plus = end_ - position_ > 1 && *position_ == '+' && position_[1] != '-';
    return position_ + is_plus;
  }

  // Returns whether a number, read up to p, goes on as in -1.#IND, 1.#INF, 1.#QNAN and 1.#SNAN,
  // which old programs write.
  bool is_old_nan(const char* p) const
  {
    return end_ - p > 1 && p[-1] == '.' && *p == '#' &&
           (p[1] == 'I' || p[1] == 'Q' || p[1] == 'S');
  }

  std::size_t line() const
  {
    std::size_t result = 1;
    for (const char* p = begin_; p != position_; ++p)
      result += *p == '\n' || (*p == '\r' && (p + 1 == end_ || p[1] != '\n'));
    return result;
  }

  // Reads a number out of the range of double, which parse_decimal() may not have set.
  static double rounded(std::string_view word)
  { return std::strtod(std::string(word).c_str(), nullptr); }

public:
  explicit Text_scanner(std::string_view text)
    : begin_(text.data()), position_(begin_), end_(begin_ + text.size())
  {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") // byte order mark of UTF-8
      position_ += 3;
  }

  // Ends the text before the zeros and bytes 0x1A of DOS that fill up some files.
  void remove_padding()
  {
    const std::size_t last = rest().find_last_not_of(std::string_view("\0\x1A \t\r\n", 6));
    const std::size_t size = rest().find_first_of(std::string_view("\0\x1A", 2), last + 1);
    end_ = position_ + (std::min)(size, rest().size());
  }

  // Skips blanks, continued line ends and a comment, but not the end of the line.
  void skip_blanks()
  {
    for (; position_ != end_; ++position_) {
      if (*position_ == '#') {
        skip_to_end_of_line();
        return;
      }
      if (is_continuation(position_)) {
        ++position_;
        if (*position_ == '\r' && end_ - position_ > 1 && position_[1] == '\n')
          ++position_;
      }
      else if (!is_blank(*position_))
        return;
    }
  }

  void skip_space()
  {
    for (skip_blanks(); position_ != end_ && is_end_of_line(*position_); skip_blanks())
      skip_end_of_line();
  }

  bool is_at_end_of_line()
  {
    skip_blanks();
    return position_ == end_ || is_end_of_line(*position_);
  }

  // Returns whether the text ends after white space, comments, and the zeros and bytes 0x1A that
  // some files have between statements. Skips all these.
  bool is_at_end()
  {
    for (skip_space(); is_at('\0') || is_at('\x1A'); skip_space())
      ++position_;
    return position_ == end_;
  }

  // Skips the words on the rest of the line.
  void skip_rest_of_line()
  {
    while (!is_at_end_of_line())
      skip_word();
  }

  // Returns the rest of the line, including comments, and moves to the next line.
  std::string_view rest_of_line()
  {
    const char* const first = position_;
    skip_to_end_of_line();
    const std::string_view result(first, static_cast<std::size_t>(position_ - first));
    if (position_ != end_)
      skip_end_of_line();
    return result;
  }

  // Returns the rest of the line without the blanks around it, including comments. Does not move.
  std::string_view peek_rest_of_line() const
  {
    const char *first = position_, *last = position_;
    while (last != end_ && !is_end_of_line(*last))
      ++last;
    while (first != last && is_blank(*first))
      ++first;
    while (last != first && is_blank(last[-1]))
      --last;
    return {first, static_cast<std::size_t>(last - first)};
  }

  // Returns the next word, which is empty at the end of the text. Does not move.
  std::string_view peek_word() const
  {
    const char* p = position_;
    while (!is_after_word(p))
      ++p;
    return {position_, static_cast<std::size_t>(p - position_)};
  }

  void skip_word() { position_ += peek_word().size(); }

  std::string_view word()
  {
    skip_space();
    const std::string_view result = peek_word();
    position_ += result.size();
    return result;
  }

  std::string_view all() const { return {begin_, static_cast<std::size_t>(end_ - begin_)}; }

  // Returns the bytes from the position on.
  std::string_view rest() const
  { return {position_, static_cast<std::size_t>(end_ - position_)}; }

  std::string at_line(const std::string& sentence) const
  { return "line " + std::to_string(line()) + ": " + sentence; }

  // Returns a message that the word at the position, if there is one, is not `expected`.
  std::string contradiction(const std::string& expected) const
  {
    const std::string_view word = peek_word();
    return at_line(word.empty() ? (position_ == end_ ? "the file ends where "
                                                     : "the line ends where ") +
                                    expected + " should be"
                                : in_quotes(word) + " is not " + expected);
  }

  [[noreturn]] void fail(const std::string& expected) const
  { throw std::runtime_error(contradiction(expected)); }

  [[noreturn]] void fail_with(const std::string& sentence) const
  { throw std::runtime_error(at_line(sentence)); }

  // Reads a number on this line or a later one. It may be infinite or NaN.
  double number()
  {
    if (const std::optional<double> result = find_number())
      return *result;
    fail("a number");
  }

  // Reads the numbers on the rest of the line.
  std::vector<double> numbers_on_line()
  {
    std::vector<double> result;
    while (!is_at_end_of_line())
      result.push_back(number());
    return result;
  }

  // Reads a number like `number()`, but does not move past a word that is none.
  std::optional<double> find_number()
  {
    skip_space();
    const char* const first = after_plus();
    double result = 0;
    auto [last, error] = parse_decimal(first, end_, result);
    if (error == std::errc::result_out_of_range)
      result = rounded({first, static_cast<std::size_t>(last - first)});
    if (error == std::errc() && is_old_nan(last)) {
      result = std::numeric_limits<double>::quiet_NaN();
      do
        ++last;
      while (!is_after_word(last));
    }
    if (error == std::errc::invalid_argument || !is_after_word(last))
      return {};
    position_ = last;
    return result;
  }

  // Reads a number from `smallest` to `largest`, which may be followed by other characters.
  long long digits(long long smallest, long long largest, const char* expected)
  {
    long long result = 0;
    const char* const first = after_plus();
    const auto [last, error] = std::from_chars(first, end_, result);
    if (error != std::errc() || result < smallest || result > largest)
      fail(expected);
    position_ = last;
    return result;
  }

  // Reads a word that is a number from `smallest` to `largest`, on this line or a later one.
  long long integer(long long smallest, long long largest, const char* expected)
  {
    skip_space();
    const char* const first = position_;
    const long long result = digits(smallest, largest, expected);
    if (!is_after_word(position_)) {
      position_ = first;
      fail(expected);
    }
    return result;
  }

  bool is_at(char c) const { return position_ != end_ && *position_ == c; }

  // Skips a character, and returns true, if it is the next one.
  bool skip(char c)
  {
    const bool result = is_at(c);
    position_ += result;
    return result;
  }

  bool is_after_word() const { return is_after_word(position_); }
};

inline std::string lower_case(std::string_view word)
{
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c)
                 { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_TEXT_SCANNER_H
