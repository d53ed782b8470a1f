// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_BYTE_SCANNER_H
#define SEGMENT_MESH_MESH_FILE_BYTE_SCANNER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mesh_file {

// Numbers of binary data in either order of bytes. All functions throw `std::runtime_error` with
// the byte at fault, counted from 0.
class Byte_scanner
{
  std::string_view bytes_;
  std::size_t position_;
  bool is_big_endian_;

  template <class Number>
  static Number value(const char* bytes, bool is_big_endian)
  {
    // Shifts mean the same on every machine; compilers make a load of them.
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bits |= std::uint64_t(static_cast<unsigned char>(bytes[i]))
              << 8 * (is_big_endian ? sizeof(Number) - 1 - i : i);
    if constexpr (sizeof(Number) == 8)
      return bit_cast<Number>(bits);
    else if constexpr (sizeof(Number) == 4)
      return bit_cast<Number>(static_cast<std::uint32_t>(bits));
    else
      return static_cast<Number>(bits);
  }

  template <class To, class From>
  static To bit_cast(const From& from)
  {
    static_assert(sizeof(To) == sizeof(From));
    To result;
    std::memcpy(&result, &from, sizeof(To));
    return result;
  }

public:
  Byte_scanner(std::string_view bytes, std::size_t position, bool is_big_endian)
    : bytes_(bytes), position_(position), is_big_endian_(is_big_endian) {}

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }

  // Throws with the position `at`, counted from the begin of the data.
  [[noreturn]] static void fail(std::size_t at, const std::string& sentence)
  { throw std::runtime_error("byte " + std::to_string(at) + ": " + sentence); }

  void require(std::size_t size, const char* what) const
  {
    if (remaining() < size)
      fail(bytes_.size(), std::string("the file ends where ") + what + " should be");
  }

  void skip(std::size_t size, const char* what)
  {
    require(size, what);
    position_ += size;
  }

  template <class Number>
  Number number(const char* what = "a number")
  {
    require(sizeof(Number), what);
    const Number result = value<Number>(bytes_.data() + position_, is_big_endian_);
    position_ += sizeof(Number);
    return result;
  }

  template <class Number>
  std::array<double, 3> point()
  {
    std::array<double, 3> result;
    for (double& c : result)
      c = static_cast<double>(number<Number>("a coordinate"));
    return result;
  }

  // Checks that the rest is only filled up with zeros and white space.
  void finish(const std::string& last) const
  {
    const std::size_t more =
      bytes_.find_first_not_of(std::string_view("\0 \t\r\n\x1A", 6), position_);
    if (more != std::string_view::npos)
      fail(more, "there is more after " + last);
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_BYTE_SCANNER_H
