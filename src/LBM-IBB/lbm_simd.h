// SPDX-License-Identifier: GPL-2.0-only
// The one place that knows how wide the machine is: packs of numbers as compiler vector types
// (GCC and Clang), and loops unrolled at compile time.
//
// A Pack<W> is loaded from and stored to any address; Pack<1> is a plain number, so the same kernel
// serves for whole packs and for the tail of a row.

#ifndef LBM_SIMD_H
#define LBM_SIMD_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

namespace lbm {

#if defined(__AVX512F__)
constexpr int SIMD_WIDTH = 8;
#elif defined(__AVX__)
constexpr int SIMD_WIDTH = 4;
#else
constexpr int SIMD_WIDTH = 2;
#endif

#define LBM_INLINE __attribute__((always_inline))

namespace detail {
  template <class T, int W> struct Vector {
    typedef T type __attribute__((vector_size(W * sizeof(T))));
  };
  template <class T> struct Vector<T, 1> {
    using type = T;
  };
  template <class F, int... I>
  LBM_INLINE inline void unroll(F &&f, std::integer_sequence<int, I...>)
  {
    (f(std::integral_constant<int, I>{}), ...);
  }
}    // namespace detail

template <int W, class Real = double> using Pack = typename detail::Vector<Real, W>::type;
template <int W> using PackInt = typename detail::Vector<int32_t, W>::type;
template <int W> using PackFloat = typename detail::Vector<float, W>::type;

// numbers in a pack as wide as the machine
template <class Real> constexpr int width = SIMD_WIDTH *int(sizeof(double) / sizeof(Real));

// f(0), f(1), ... f(N-1), each with its index known at compile time
template <int N, class F> LBM_INLINE inline void unroll(F &&f)
{
  detail::unroll(f, std::make_integer_sequence<int, N>{});
}

template <class V, class T> LBM_INLINE inline V load(const T *p)
{
  V v;
  std::memcpy(&v, p, sizeof(V));
  return v;
}

template <class V, class T> LBM_INLINE inline void store(T *p, const V &v)
{
  std::memcpy(p, &v, sizeof(V));
}

// v where owner < 0 (fluid), else the other
template <int W, class V>
LBM_INLINE inline V where_fluid(const PackInt<W> &owner, const V &v, const V &other = V{})
{
  if constexpr (W == 1) {
    return owner < 0 ? v : other;
  } else {
    using Mask = Pack<W, std::conditional_t<sizeof(V) == W * sizeof(float), int32_t, int64_t>>;
    const Mask fluid = __builtin_convertvector(owner < 0, Mask);
    return fluid ? v : other;
  }
}

// is any of W numbers negative?
template <int W> LBM_INLINE inline bool any_negative(const int32_t *p)
{
  if constexpr (W == 1) {
    return *p < 0;
  } else {
    uint64_t pair[W / 2], any = 0;
    std::memcpy(pair, p, sizeof(pair));
    for (uint64_t two : pair) any |= two;
    return any & 0x8000000080000000u;
  }
}

// number by number, to a pack of another type
template <class To, class From> LBM_INLINE inline To convert(const From &v)
{
  if constexpr (std::is_arithmetic_v<From>)
    return static_cast<To>(v);
  else
    return __builtin_convertvector(v, To);
}

namespace detail {
  // written as a list, because filling a pack one by one makes each number wait for the one before
  template <class V, class T, int... K>
  LBM_INLINE inline V gather(const T *p, const int32_t *n, std::integer_sequence<int, K...>)
  {
    return V{p[n[K]]...};
  }
}    // namespace detail

template <int W, class T> LBM_INLINE inline auto gather(const T *p, const int32_t *n)
{
  using V = typename detail::Vector<T, W>::type;
  return detail::gather<V>(p, n, std::make_integer_sequence<int, W>{});
}

template <int W, class T> LBM_INLINE inline void scatter(T *p, const int32_t *n, const Pack<W> &v)
{
  if constexpr (W == 1)
    p[*n] = T(v);
  else
    for (int k = 0; k < W; k++) p[n[k]] = T(v[k]);
}

// sum of the numbers of a pack: halves are added until one is left
inline double total(const double &v)
{
  return v;
}
template <class V> LBM_INLINE inline double total(const V &v)
{
  constexpr int W = sizeof(V) / sizeof(double);
  Pack<W / 2> half[2];
  std::memcpy(half, &v, sizeof(V));
  return total(half[0] + half[1]);
}

template <class V> LBM_INLINE inline V root(const V &v)
{
  if constexpr (std::is_arithmetic_v<V>) {
    return std::sqrt(v);
  } else {
    V r = v;
    for (unsigned k = 0; k < sizeof(V) / sizeof(v[0]); k++) r[k] = std::sqrt(v[k]);
    return r;
  }
}

// Bits k = 0..63 of p[k] == value (or p[k] < 0). Reads 64 numbers.
struct Bits {
  uint64_t equal, negative;
};
inline Bits compare(const int32_t *p, int32_t value)
{
  Bits bits{0, 0};
#if defined(__AVX512F__)
  const __m512i v = _mm512_set1_epi32(value);
  for (int k = 0; k < 64; k += 16) {
    const __m512i x = _mm512_loadu_si512(p + k);
    bits.equal |= uint64_t(_mm512_cmpeq_epi32_mask(x, v)) << k;
    bits.negative |= uint64_t(_mm512_cmplt_epi32_mask(x, _mm512_setzero_si512())) << k;
  }
#elif defined(__AVX2__)
  const __m256i v = _mm256_set1_epi32(value);
  for (int k = 0; k < 64; k += 8) {
    const __m256i x = _mm256_loadu_si256(reinterpret_cast<const __m256i *>(p + k));
    const auto signs = [](__m256i m) {
      return uint64_t(uint8_t(_mm256_movemask_ps(_mm256_castsi256_ps(m))));
    };
    bits.equal |= signs(_mm256_cmpeq_epi32(x, v)) << k;
    bits.negative |= signs(x) << k;
  }
#else
  for (int k = 0; k < 64; k++) {
    bits.equal |= uint64_t(p[k] == value) << k;
    bits.negative |= uint64_t(p[k] < 0) << k;
  }
#endif
  return bits;
}

}    // namespace lbm
#endif
