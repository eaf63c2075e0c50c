#include "motion/bytes.h"

#include <bit>
#include <cassert>

#include "motion/problem.h"

namespace promenade {
namespace {

template <typename Unsigned>
void append(std::string& bytes, Unsigned value) {
  for (std::size_t b = 0; b < sizeof value; ++b) {
    bytes.push_back(static_cast<char>((value >> (8 * b)) & 0xff));
  }
}

template <typename Unsigned>
Unsigned from_little_endian(std::string_view bytes) {
  Unsigned value = 0;
  for (std::size_t b = sizeof value; b-- > 0;) {
    value = static_cast<Unsigned>((value << 8) | static_cast<unsigned char>(bytes[b]));
  }
  return value;
}

}  // namespace

void ByteWriter::u32(std::uint32_t value) { append(bytes_, value); }
void ByteWriter::u64(std::uint64_t value) { append(bytes_, value); }
void ByteWriter::f64(double value) { append(bytes_, std::bit_cast<std::uint64_t>(value)); }
void ByteWriter::f32(float value) { append(bytes_, std::bit_cast<std::uint32_t>(value)); }

void ByteWriter::count(std::size_t value) {
  assert(value <= UINT32_MAX && "counts are written in 32 bits");
  u32(static_cast<std::uint32_t>(value));
}

void ByteWriter::text(std::string_view value) {
  count(value.size());
  bytes_.append(value);
}

void ByteWriter::numbers(const double* values, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) f64(values[i]);
}

ByteReader::ByteReader(std::string_view bytes, std::string file)
    : rest_(bytes), file_(std::move(file)) {}

void ByteReader::fail(const std::string& message) const { throw InputError(file_, message); }

std::string_view ByteReader::take(std::size_t size) {
  if (size > rest_.size()) fail("ends too early; copy or build it again");
  const std::string_view taken = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return taken;
}

std::uint32_t ByteReader::u32() { return from_little_endian<std::uint32_t>(take(4)); }
std::uint64_t ByteReader::u64() { return from_little_endian<std::uint64_t>(take(8)); }
double ByteReader::f64() { return std::bit_cast<double>(u64()); }
float ByteReader::f32() { return std::bit_cast<float>(u32()); }

std::size_t ByteReader::count(std::size_t least_bytes) {
  assert(least_bytes > 0 && "things without bytes cannot be bounded by the file");
  const std::size_t value = u32();
  if (value > rest_.size() / least_bytes) fail("ends too early; copy or build it again");
  return value;
}

std::string ByteReader::text() { return std::string(take(count(1))); }

void ByteReader::numbers(double* values, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) values[i] = f64();
}

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ull;
  }
  return hash;
}

}  // namespace promenade
