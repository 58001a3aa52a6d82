// SPDX-License-Identifier: GPL-2.0-only
// Functions on packs that are written once more for some processors: each against a plain loop.

#include "lbm_simd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace lbm;

namespace {

template <class V> class Packs : public ::testing::Test {
};
using Doubles = ::testing::Types<Pack<2>, Pack<SIMD_WIDTH>>;    // every machine has packs of two
TYPED_TEST_SUITE(Packs, Doubles);

template <class V> constexpr int numbers_in = int(sizeof(V) / sizeof(double));

// masks with few, half and most of their bits set, and the extremes
std::vector<uint64_t> masks()
{
  std::vector<uint64_t> all{0,      1,          uint64_t(1) << 63,  ~uint64_t(0),
                            0xffff, 0xffff0000, 0x8000800080008000u};
  std::mt19937_64 random(1);
  for (int k = 0; k < 1000; k++) {
    const uint64_t a = random(), b = random(), c = random();
    all.insert(all.end(), {a, a & b & c, a | b | c});
  }
  return all;
}

TEST(AppendBits, EqualsAPlainLoop)
{
  constexpr int32_t UNTOUCHED = -7, first = 1000000007;
  for (const uint64_t mask : masks()) {
    std::vector<int32_t> expected;
    for (int k = 0; k < 64; k++)
      if (mask >> k & 1) expected.push_back(first + k);
    const std::size_t size = expected.size();
    // one entry stands before, and what is beyond the room for 16 more is not ours to write
    std::vector<int32_t> list(1 + size + 16 + 1, UNTOUCHED);
    const auto begin = list.begin() + 1;
    ASSERT_EQ(append_bits(mask, first, &*begin), &*begin + size) << std::hex << mask;
    EXPECT_EQ(list.front(), UNTOUCHED);
    EXPECT_EQ(list.back(), UNTOUCHED);
    EXPECT_EQ(std::vector<int32_t>(begin, begin + int(size)), expected) << std::hex << mask;
  }
}

// whole numbers add up to the same in any order
TYPED_TEST(Packs, AddTotalsIncreasesEachNumberByItsOwnSum)
{
  using V = TypeParam;
  constexpr int W = numbers_in<V>;
  std::mt19937 random(2);
  std::uniform_int_distribution<int> number(-1000000, 1000000);
  for (int trial = 0; trial < 100; trial++) {
    V v[8];
    double sums[9], expected[9];
    for (int n = 0; n < 9; n++) sums[n] = expected[n] = number(random);
    for (int n = 0; n < 8; n++)
      for (int k = 0; k < W; k++) expected[n] += v[n][k] = number(random);
    add_totals(v, sums);
    for (int n = 0; n < 9; n++) EXPECT_EQ(sums[n], expected[n]) << "number " << n;
  }
}

// also if what is left out is not a number
TYPED_TEST(Packs, FirstOfKeepsTheFirst)
{
  using V = TypeParam;
  constexpr int W = numbers_in<V>;
  for (int n = 0; n <= W; n++) {
    V v, others;
    for (int k = 0; k < W; k++) {
      v[k] = k < n ? 1.5 * k : std::numeric_limits<double>::quiet_NaN();
      others[k] = k < n ? std::numeric_limits<double>::quiet_NaN() : 100.0 + k;
    }
    const V first = first_of(v, n, others);
    for (int k = 0; k < W; k++)
      EXPECT_EQ(first[k], k < n ? 1.5 * k : 100.0 + k) << n << " of " << W;
  }
}

TEST(FirstOf, TakesIndicesToo)
{
  constexpr int W = SIMD_WIDTH;
  for (int n = 0; n <= W; n++) {
    PackInt<W> v;
    for (int k = 0; k < W; k++) v[k] = k - 1;
    const PackInt<W> first = first_of(v, n, PackInt<W>{} + 77);
    for (int k = 0; k < W; k++) EXPECT_EQ(first[k], k < n ? k - 1 : 77) << n << " of " << W;
  }
}

// IEEE 754 asks for the nearest number, so that packs and single numbers agree to the bit
TYPED_TEST(Packs, RootIsThatOfEachNumber)
{
  using V = TypeParam;
  constexpr int W = numbers_in<V>;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int trial = 0; trial < 1000; trial++) {
    V v;
    for (int k = 0; k < W; k++) v[k] = std::pow(10.0, exponent(random));
    if (trial == 0) v = V{};
    const V r = root(v);
    for (int k = 0; k < W; k++) EXPECT_EQ(r[k], std::sqrt(v[k])) << v[k];
  }
  EXPECT_EQ(root(2.25), 1.5);
}

}    // namespace
