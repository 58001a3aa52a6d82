// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_obstacle.h"

#include "lbm_link.h"

#include <algorithm>

namespace lbm {
namespace {

  // Links are looked at in so many pieces for the first that ends inside; halving it 40 times
  // leaves 1e-13 of a cell
  constexpr int PIECES = 8, HALVINGS = 40;
  // what lies this deep below its own surface is no thin part, looked at in steps
  constexpr double THICK = 2.0, STEP = 0.125;
  // how far a surface is moved to see whether it stays in place, and how far off it points lie
  constexpr double SHIFT = 0.25, OFF = 0.02;

  Vec3 added(const Vec3 &a, double s, const Vec3 &b)
  {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
  }

  // x after a time of rigid motion (Rodrigues)
  Vec3 moved(const Shape &shape, const Vec3 &x, double time)
  {
    Vec3 arm = added(x, -1.0, shape.about);
    const double rate = std::sqrt(dot(shape.spin, shape.spin)), angle = rate * time;
    if (rate > 0.0) {
      const Vec3 axis = added({}, 1.0 / rate, shape.spin), turn = cross(axis, arm);
      const double along = dot(axis, arm) * (1.0 - std::cos(angle));
      for (int d = 0; d < 3; d++)
        arm[d] = arm[d] * std::cos(angle) + turn[d] * std::sin(angle) + axis[d] * along;
    }
    return added(added(shape.about, 1.0, arm), time, shape.velocity);
  }

  std::uint64_t mixed(std::uint64_t h, std::uint64_t word)
  {
    h = (h ^ word) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 29)) * 0xc4ceb9fe1a85ec53ull;
    return h ^ (h >> 32);
  }

}    // namespace

template <class L> class Obstacles::Search {
 public:
  Search(const Layout &at, const Place &place, Obstacles &to) :
      at(at), place(place), to(to), owner(std::size_t(at.size), FLUID)
  {
  }

  void find()
  {
    to.near_.assign(to.shapes_.size(), Region{{1, 1, 1}, {0, 0, 0}});
    to.reviews_.resize(to.shapes_.size());
    cover();
    for_each_node(at.all(), [&](const Int3 &p) {
      look_at(p);
    });
    for_each_node(at.all(), [&](const Int3 &p) {
      if (owner[at.index(p[0], p[1], p[2])] >= 0) look_at_covered(p);
    });
    to.link_.shrink_to_fit();
    to.q_.shrink_to_fit();
  }

 private:
  const Layout &at;
  const Place &place;
  Obstacles &to;
  std::vector<int32_t> owner;    // obstacle, or FLUID

  template <class F> void for_each_node(const Region &region, F &&f) const
  {
    for (int z = region.lo[2]; z <= region.hi[2]; z++)
      for (int y = region.lo[1]; y <= region.hi[1]; y++)
        for (int x = region.lo[0]; x <= region.hi[0]; x++) f(Int3{x, y, z});
  }

  // the node's place in the box, the same on every rank that has it
  Vec3 point(const Int3 &p) const
  {
    Vec3 x;
    for (int d = 0; d < 3; d++) {
      const int n = place.global[d];
      const int g = place.periodic[d] ? (p[d] + at.lo[d] + n) % n : p[d] + at.lo[d];
      x[d] = g + 0.5;
    }
    return x;
  }
  Vec3 wrapped(Vec3 x) const
  {
    for (int d = 0; d < 3; d++)
      if (place.periodic[d]) x[d] -= place.global[d] * std::floor(x[d] / place.global[d]);
    return x;
  }
  bool in_box(const Vec3 &x) const
  {
    for (int d = 0; d < L::D; d++)
      if (!place.periodic[d] && (x[d] < 0.0 || x[d] > place.global[d])) return false;
    return true;
  }
  bool inside(std::size_t k, const Vec3 &x) const { return to.shapes_[k].inside(wrapped(x)); }
  bool inside_any(const Vec3 &x) const
  {
    const Vec3 w = wrapped(x);
    return std::any_of(to.shapes_.begin(), to.shapes_.end(), [&](const Shape &shape) {
      return shape.inside(w);
    });
  }
  int32_t owner_at(const Int3 &p, const int (&e)[3]) const
  {
    return owner[std::size_t(at.index(p[0] + e[0], p[1] + e[1], p[2] + e[2]))];
  }
  bool known(const Int3 &p, const int (&e)[3]) const
  {
    for (int d = 0; d < 3; d++)
      if (p[d] + e[d] < place.lo[d] || p[d] + e[d] > place.hi[d]) return false;
    return true;
  }

  void cover()
  {
    for_each_node({place.lo, place.hi}, [&](const Int3 &p) {
      const Vec3 x = point(p);
      for (std::size_t k = 0; k < to.shapes_.size(); k++) {
        if (!to.shapes_[k].inside(x)) continue;
        const Index n = at.index(p[0], p[1], p[2]);
        owner[std::size_t(n)] = int32_t(k);
        auto &list = to.stretches_;
        if (!list.empty() && list.back().obstacle == int(k) &&
            list.back().first + list.back().n == n)
          list.back().n++;
        else
          list.push_back({n, 1, int(k)});
        return;
      }
    });
  }

  // links of a node that no obstacle covers
  void look_at(const Int3 &p)
  {
    const Index n = at.index(p[0], p[1], p[2]);
    if (owner[std::size_t(n)] >= 0) return;
    for (int i = 1; i < L::Q; i++) {
      const int32_t k = owner_at(p, L::e[i]);
      if (k >= 0)
        add_link(p, n, i, k);
      else if (i <= L::P && known(p, L::e[i]) && dot(L::e[i], axis_of(i)) == 1.0)
        look_between(p, L::e[i]);
    }
  }
  static Vec3 axis_of(int i)
  {
    const int(&e)[3] = L::e[i];
    return {double(e[0]), double(e[1]), double(e[2])};
  }

  void add_link(const Int3 &p, Index n, int i, int32_t k)
  {
    const Vec3 x = point(p), e = axis_of(i);
    double out = 0.0, in = 1.0;
    for (int s = 1; s < PIECES; s++) {
      const double q = double(s) / PIECES;
      if (inside_any(added(x, q, e))) {
        in = q;
        break;
      }
      out = q;
    }
    for (int h = 0; h < HALVINGS; h++) {
      const double middle = 0.5 * (out + in);
      (inside_any(added(x, middle, e)) ? in : out) = middle;
    }
    const double q = std::max(0.5 * (out + in), Q_MIN);
    to.link_.push_back(name(int32_t(n), i));
    to.q_.push_back(q);
    Region &near = to.near_[k];
    const bool first = near.empty();
    for (int d = 0; d < 3; d++) {
      near.lo[d] = first ? p[d] : std::min(near.lo[d], p[d]);
      near.hi[d] = first ? p[d] : std::max(near.hi[d], p[d]);
    }
    review_link(x, e, i, k, q);
  }

  void review_link(const Vec3 &x, const Vec3 &e, int i, int32_t k, double q)
  {
    ShapeReview &review = to.reviews_[k];
    review.links++;
    std::uint64_t h = mixed(std::uint64_t(i), std::uint64_t(std::llround(q * 1e9)));
    for (int d = 0; d < 3; d++) h = mixed(h, std::uint64_t(std::llround(x[d] + 0.5)));
    review.checksum += mixed(h, std::uint64_t(k));
    const Shape &shape = to.shapes_[k];
    const Vec3 u = to.body(k).velocity_at(added(added(x, q, e), -1.0, shape.about));
    const double speed = std::sqrt(dot(u, u));
    review.speed = std::max(review.speed, speed);
    if (!(speed > 0.0)) return;
    bool leaves = false;
    for (double off : {-OFF, OFF}) {
      const Vec3 y = added(x, q + off, e), z = moved(shape, y, SHIFT / speed);
      leaves = leaves || (in_box(y) && in_box(z) && inside(k, y) != inside(k, z));
    }
    review.leaving += leaves;
  }

  // a solid between two nodes, and not because the link cuts off a bulge
  void look_between(const Int3 &p, const int (&e)[3])
  {
    const Vec3 middle = added(point(p), 0.5, {double(e[0]), double(e[1]), double(e[2])});
    for (std::size_t k = 0; k < to.shapes_.size(); k++) {
      if (!inside(k, middle)) continue;
      bool covered = false;
      for (int i = 1; i < L::Q; i++) covered = covered || owner_at(p, L::e[i]) >= 0;
      to.reviews_[k].missed += !covered;
    }
  }

  void look_at_covered(const Int3 &p)
  {
    const int32_t k = owner[std::size_t(at.index(p[0], p[1], p[2]))];
    ShapeReview &review = to.reviews_[k];
    review.covered++;
    const Vec3 x = point(p);
    std::uint64_t h = mixed(97, std::uint64_t(k));
    for (int d = 0; d < 3; d++) h = mixed(h, std::uint64_t(std::llround(x[d] + 0.5)));
    review.checksum += h;
    Vec3 normal{};
    bool surface = false;
    for (int i = 1; i < L::Q; i++)
      if (known(p, L::e[i]) && owner_at(p, L::e[i]) < 0) {
        surface = true;
        normal = added(normal, L::w[i], axis_of(i));
      }
    if (!surface) return;
    review.surface++;
    review.thin += thickness(x, normal) < THICK;
  }

  // along the normal, as far as it matters; of a part with fluid all around it nothing is known
  double thickness(const Vec3 &x, const Vec3 &normal) const
  {
    const double length = std::sqrt(dot(normal, normal));
    if (length < 1e-6) return 0.0;
    int steps = 0;    // both ways
    for (double way : {-STEP / length, STEP / length})
      for (int s = 1; steps * STEP < THICK; s++, steps++) {
        const Vec3 y = added(x, way * s, normal);
        if (in_box(y) && !inside_any(y)) break;
      }
    return steps * STEP;
  }
};

template <class L>
Obstacles Obstacles::find(const Layout &at, const Place &place, const std::vector<Shape> &shapes)
{
  Obstacles found;
  found.shapes_ = shapes;
  Search<L>(at, place, found).find();
  for (Shape &shape : found.shapes_) shape.inside = nullptr;    // not asked again: it may be gone
  return found;
}

Sphere Obstacles::body(int k) const
{
  const Shape &shape = shapes_[k];
  return {-1 - k, shape.about, 0.0, shape.velocity, shape.spin};
}

void Obstacles::fractions(const int32_t *node, std::size_t n, int i, double *q) const
{
  auto from = link_.begin();
  for (std::size_t l = 0; l < n; l++) {
    const std::uint64_t wanted = name(node[l], i);
    std::ptrdiff_t reach = 8;    // the next is seldom far away
    while (link_.end() - from > reach && from[reach] < wanted) {
      from += reach;
      reach *= 2;
    }
    const auto end = link_.end() - from > reach ? from + reach + 1 : link_.end();
    from = std::lower_bound(from, end, wanted);
    q[l] = q_[std::size_t(from - link_.begin())];
  }
}

double Obstacles::fraction(int32_t node, int i) const
{
  double q;
  fractions(&node, 1, i, &q);
  return q;
}

void reduce(std::vector<ShapeReview> &reviews, Neighbours &neighbours)
{
  // a checksum in pieces that add up without rounding, on millions of ranks
  constexpr int PART = 16, PARTS = 4;
  std::vector<double> sums, most;
  for (const ShapeReview &r : reviews) {
    sums.insert(sums.end(), {r.covered, r.links, r.surface, r.thin, r.missed, r.leaving});
    for (int k = 0; k < PARTS; k++) sums.push_back(double((r.checksum >> (PART * k)) & 0xffff));
    most.push_back(r.speed);
  }
  neighbours.sum(sums.data(), int(sums.size()));
  neighbours.max(most.data(), int(most.size()));
  const double *s = sums.data();
  for (std::size_t n = 0; n < reviews.size(); n++, s += 6 + PARTS) {
    reviews[n] = {s[0], s[1], s[2], s[3], s[4], s[5], most[n], 0};
    for (int k = 0; k < PARTS; k++) reviews[n].checksum += std::uint64_t(s[6 + k]) << (PART * k);
  }
}

double Obstacles::bytes() const
{
  return double(link_.capacity() * sizeof(std::uint64_t) + q_.capacity() * sizeof(double) +
                stretches_.capacity() * sizeof(Stretch));
}

#define LBM_INSTANTIATE(L) \
  template Obstacles Obstacles::find<L>(const Layout &, const Place &, const std::vector<Shape> &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
