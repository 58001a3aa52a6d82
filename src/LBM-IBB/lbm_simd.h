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
  template <class V, class F, int... K>
  LBM_INLINE inline V list(F &&f, std::integer_sequence<int, K...>)
  {
    return V{f(K)...};
  }
}    // namespace detail

// the pack of f(0), f(1), ... f(W-1)
template <int W, class F> LBM_INLINE inline auto pack_of(F &&f)
{
  using V = typename detail::Vector<std::decay_t<decltype(f(0))>, W>::type;
  return detail::list<V>(f, std::make_integer_sequence<int, W>{});
}

template <int W, class T> LBM_INLINE inline auto gather(const T *p, const int32_t *n)
{
  return pack_of<W>([&](int k) LBM_INLINE {
    return p[n[k]];
  });
}

// its first n numbers, and others in place of the rest
template <class V> LBM_INLINE inline V first_of(const V &v, int n, const V &others)
{
  using T = std::decay_t<decltype(v[0])>;
  constexpr int W = int(sizeof(V) / sizeof(T));
  const V lanes = pack_of<W>([](int k) LBM_INLINE {
    return T(k);
  });
  return lanes < V{} + T(n) ? v : others;
}

template <int W, class T> LBM_INLINE inline void scatter(T *p, const int32_t *n, const Pack<W> &v)
{
  if constexpr (W == 1)
    p[*n] = T(v);
  else
    for (int k = 0; k < W; k++) p[n[k]] = T(v[k]);
}

// Append first + k for each bit k, from p on, which has room for 16 more. Returns the new end.
inline int32_t *append_bits(uint64_t bits, int32_t first, int32_t *p)
{
#if defined(__AVX512F__)
  // the pack is compressed, then stored as a whole: to store what is chosen is slow on some
  __m512i n =
      _mm512_add_epi32(_mm512_set1_epi32(first),
                       _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  do {
    _mm512_storeu_si512(p, _mm512_maskz_compress_epi32(__mmask16(bits), n));
    p += __builtin_popcount(unsigned(bits & 0xffff));
    n = _mm512_add_epi32(n, _mm512_set1_epi32(16));
    bits >>= 16;
  } while (bits);
#else
  for (; bits; bits &= bits - 1) *p++ = first + __builtin_ctzll(bits);
#endif
  return p;
}

#if defined(__AVX512F__)
// of the eight numbers of a pack: gcc 12 warns of the functions that take no mask
constexpr __mmask8 ALL = 0xff;
#endif

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

// increase eight numbers by the totals of eight packs, of which each step below makes half as many
template <class V> LBM_INLINE inline void add_totals(const V (&v)[8], double *sums)
{
#if defined(__AVX512F__)
  if constexpr (sizeof(V) == sizeof(__m512d)) {
    const auto pairs = [](const V &a, const V &b) LBM_INLINE {
      return V(_mm512_maskz_unpacklo_pd(ALL, a, b)) + V(_mm512_maskz_unpackhi_pd(ALL, a, b));
    };
    const auto quarters = [](const V &a, const V &b) LBM_INLINE {
      return V(_mm512_maskz_shuffle_f64x2(ALL, a, b, 0x88)) +
          V(_mm512_maskz_shuffle_f64x2(ALL, a, b, 0xdd));
    };
    const V all = quarters(quarters(pairs(v[0], v[1]), pairs(v[2], v[3])),
                           quarters(pairs(v[4], v[5]), pairs(v[6], v[7])));
    store(sums, load<V>(sums) + all);
    return;
  }
#endif
  for (int n = 0; n < 8; n++) sums[n] += total(v[n]);
}

template <class V> LBM_INLINE inline V root(const V &v)
{
  if constexpr (std::is_arithmetic_v<V>) {
    return std::sqrt(v);
  } else {
#if defined(__AVX512F__)
    if constexpr (sizeof(V) == sizeof(__m512d)) return _mm512_maskz_sqrt_pd(ALL, v);
#endif
#if defined(__AVX__)
    if constexpr (sizeof(V) == sizeof(__m256d)) return _mm256_sqrt_pd(v);
#endif
    V r = v;
    for (unsigned k = 0; k < sizeof(V) / sizeof(v[0]); k++) r[k] = std::sqrt(v[k]);
    return r;
  }
}

// Bits k = 0..63 of p[k] == value (or p[k] < 0), the first n of them; others may be left out, or be
// right as well. Reads up to 64 numbers.
struct Bits {
  uint64_t equal, negative;
};
inline Bits compare(const int32_t *p, int32_t value, int n = 64)
{
  Bits bits{0, 0};
#if defined(__AVX512F__)
  const __m512i v = _mm512_set1_epi32(value);
  for (int k = 0; k < n; k += 16) {
    const __m512i x = _mm512_loadu_si512(p + k);
    bits.equal |= uint64_t(_mm512_cmpeq_epi32_mask(x, v)) << k;
    bits.negative |= uint64_t(_mm512_cmplt_epi32_mask(x, _mm512_setzero_si512())) << k;
  }
#elif defined(__AVX2__)
  const __m256i v = _mm256_set1_epi32(value);
  for (int k = 0; k < n; k += 8) {
    const __m256i x = _mm256_loadu_si256(reinterpret_cast<const __m256i *>(p + k));
    const auto signs = [](__m256i m) {
      return uint64_t(uint8_t(_mm256_movemask_ps(_mm256_castsi256_ps(m))));
    };
    bits.equal |= signs(_mm256_cmpeq_epi32(x, v)) << k;
    bits.negative |= signs(x) << k;
  }
#else
  for (int k = 0; k < n; k++) {
    bits.equal |= uint64_t(p[k] == value) << k;
    bits.negative |= uint64_t(p[k] < 0) << k;
  }
#endif
  return bits;
}

}    // namespace lbm
#endif
