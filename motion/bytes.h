// Numbers and texts as bytes, little-endian, and back. The reader never looks
// past the end and never makes room for more than the bytes can hold.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace promenade {

class ByteWriter {
 public:
  void u32(std::uint32_t value);
  void u64(std::uint64_t value);
  void f64(double value);
  void f32(float value);
  void count(std::size_t value);  // as u32
  void text(std::string_view value);
  void numbers(const double* values, std::size_t size);  // without their count
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  // Throws InputError with `file` as its place whenever the bytes do not suffice.
  ByteReader(std::string_view bytes, std::string file);
  std::uint32_t u32();
  std::uint64_t u64();
  double f64();
  float f32();
  // A number of things of which each takes at least `least_bytes` (from 1).
  std::size_t count(std::size_t least_bytes);
  std::string text();
  void numbers(double* values, std::size_t size);
  bool at_end() const { return rest_.empty(); }
  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string_view take(std::size_t size);
  std::string_view rest_;
  std::string file_;
};

// FNV-1a, 64 bits: two texts that differ in one byte never agree.
std::uint64_t checksum(std::string_view bytes);

}  // namespace promenade
