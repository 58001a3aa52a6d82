// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_enclosed.h"

#include "lbm_runs.h"

#include <cmath>
#include <map>
#include <set>

namespace lbm {
namespace {

  // connected fluid of a block, or of the lattice
  struct Part {
    double nodes = 0.0;
    bool open = false;      // at an open face
    bool shared = false;    // made of several
  };

  // Names of parts by node: the first node in the order of the whole lattice, counted from 1; 0
  // where there is no fluid. In the outermost layer of the block and in its ghosts.
  class Names {
   public:
    Names(const Layout &at, int dimension) :
        at_(at), dimension_(dimension), name_(std::size_t(at.size), 0.0)
    {
    }
    double &operator[](Index n) { return name_[std::size_t(n)]; }

    // from the neighbours, to the ghosts
    void exchange(Neighbours &neighbours)
    {
      for (int d = 0; d < dimension_; d++)
        for (int side = 0; side < 2; side++) {
          std::vector<double> out;
          for_each_in_layer(d, side == 0 ? 0 : at_.n[d] - 1, [&](double name) {
            out.push_back(name);
          });
          std::vector<double> in(out.size());
          neighbours.shift(d, side, out.data(), out.size(), in.data(), in.size());
          if (!neighbours.exists(d, 1 - side)) continue;
          auto name = in.begin();
          for_each_in_layer(d, side == 0 ? at_.n[d] : -1, [&](double &to) {
            to = *name++;
          });
        }
    }

   private:
    const Layout &at_;
    int dimension_;
    std::vector<double> name_;

    // with the ghosts along the directions that are done
    template <class F> void for_each_in_layer(int d, int where, F &&f)
    {
      Int3 lo{0, 0, 0}, hi{at_.n[0] - 1, at_.n[1] - 1, at_.n[2] - 1};
      for (int p = 0; p < d; p++) {
        lo[p]--;
        hi[p]++;
      }
      lo[d] = hi[d] = where;
      for (int z = lo[2]; z <= hi[2]; z++)
        for (int y = lo[1]; y <= hi[1]; y++)
          for (int x = lo[0]; x <= hi[0]; x++) f((*this)[at_.index(x, y, z)]);
    }
  };

  // f(x, y, z) for the nodes of the outermost layer that are among xa..xb of a row
  template <class F> void for_each_outermost(const Layout &at, const Piece &p, F &&f)
  {
    const bool whole = p.y == 0 || p.y == at.n[1] - 1 ||
        (at.ghost[2] && (p.z == 0 || p.z == at.n[2] - 1));
    for (int x = p.xa; x <= p.xb; x++)
      if (whole || x == 0 || x == at.n[0] - 1)
        f(x, p.y, p.z);
      else
        x = std::max(x, std::min(p.xb, at.n[0] - 2));    // all between are inner nodes
  }

  // The parts of all blocks, by name, and the sets they make where they meet; the same everywhere
  class AllParts {
   public:
    AllParts(const std::map<double, Part> &mine, const std::set<std::pair<double, double>> &meet,
             Neighbours &neighbours)
    {
      std::vector<double> words;
      for (const auto &[name, part] : mine)
        words.insert(words.end(), {name, part.nodes, part.open ? 1.0 : 0.0});
      words = neighbours.gather(words);
      std::map<double, Part> parts;
      for (std::size_t k = 0; k < words.size(); k += 3)
        parts[words[k]] = {words[k + 1], words[k + 2] > 0.0, false};
      for (const auto &entry : parts) {
        number_[entry.first] = names_.size();
        names_.push_back(entry.first);
        joined_.add();
      }
      words.clear();
      for (const auto &[a, b] : meet) words.insert(words.end(), {a, b});
      words = neighbours.gather(words);
      for (std::size_t k = 0; k < words.size(); k += 2)
        joined_.join(number_.at(words[k]), number_.at(words[k + 1]));
      for (const auto &[name, part] : parts) {
        Part &whole = sets_[set_of(name)];
        whole.shared = whole.nodes > 0.0;
        whole.nodes += part.nodes;
        whole.open = whole.open || part.open;
      }
    }

    // named by its first part
    double set_of(double part) { return names_[joined_.smallest(number_.at(part))]; }

    // the sets that are not the rest of the fluid
    std::map<double, Part> enclosed() const
    {
      auto largest = sets_.begin();
      for (auto s = sets_.begin(); s != sets_.end(); ++s)
        if (s->second.nodes > largest->second.nodes) largest = s;
      std::map<double, Part> list;
      for (auto s = sets_.begin(); s != sets_.end(); ++s)
        if (s != largest && !s->second.open) list.insert(*s);
      return list;
    }

   private:
    std::map<double, std::size_t> number_;
    std::vector<double> names_;
    Joined joined_;
    std::map<double, Part> sets_;
  };

  // nodes that fit into the largest sphere of all blocks
  double largest_volume(const Cover &cover, int dimension, Neighbours &neighbours)
  {
    double r = 0.0;
    for (std::size_t s = 0; s < cover.spheres().size(); s++)
      if (!cover.is_obstacle(s)) r = std::max(r, cover.spheres()[s].radius);
    neighbours.max(&r, 1);
    return dimension == 3 ? 4.0 / 3.0 * M_PI * r * r * r : M_PI * r * r;
  }

}    // namespace

template <class L>
void Enclosed<L>::find(const Cover &cover, const Int3 &lattice, Neighbours &neighbours)
{
  FluidRuns<L> runs(at_, cover.owner());
  const auto &pieces = runs.pieces();
  const auto name_of = [&](std::size_t k) {
    const Piece &p = pieces[runs.first_of(k)];
    return 1.0 + (at_.lo[0] + p.xa) +
        double(lattice[0]) * (at_.lo[1] + p.y + double(lattice[1]) * (at_.lo[2] + p.z));
  };

  std::map<double, Part> mine;
  Names names(at_, L::D);
  std::vector<double> name(pieces.size());    // of the part, by piece
  for (std::size_t k = 0; k < pieces.size(); k++) {
    name[k] = runs.first_of(k) == k ? name_of(k) : name[runs.first_of(k)];
    mine[name[k]].nodes += pieces[k].xb - pieces[k].xa + 1;
    for_each_outermost(at_, pieces[k], [&](int x, int y, int z) {
      names[at_.index(x, y, z)] = name[k];
    });
  }
  names.exchange(neighbours);
  std::set<std::pair<double, double>> meet;
  for (std::size_t k = 0; k < pieces.size(); k++)
    for_each_outermost(at_, pieces[k], [&](int x, int y, int z) {
      const Index n = at_.index(x, y, z);
      for (int i = 1; i < L::Q; i++) {
        const int(&e)[3] = L::e[i];
        if (at_.owned(x + e[0], y + e[1], z + e[2])) continue;
        const Index m = n + at_.offset(e);
        if (cover.owner()[m] == OUTSIDE) mine[name[k]].open = true;
        if (names[m] > 0.0 && names[m] != name[k]) meet.insert({name[k], names[m]});
      }
    });

  AllParts all(mine, meet, neighbours);
  const auto enclosed = all.enclosed();
  const double largest = largest_volume(cover, L::D, neighbours);
  sets_ = double(enclosed.size());
  nodes_ = 0.0;
  held_.clear();
  std::map<double, std::size_t> held;    // number by name
  for (const auto &[set, part] : enclosed) {
    nodes_ += part.nodes;
    if (part.nodes < 2.0 || part.nodes > largest) continue;
    held[set] = held_.size();
    held_.push_back({part.shared, {}});
  }
  if (held.empty()) return;
  for (std::size_t k = 0; k < pieces.size(); k++) {
    const auto set = held.find(all.set_of(name[k]));
    if (set == held.end()) continue;
    for (int x = pieces[k].xa; x <= pieces[k].xb; x++)
      held_[set->second].nodes.push_back(uint32_t(at_.index(x, pieces[k].y, pieces[k].z)));
  }
}

template <class L> void Enclosed<L>::forget()
{
  sets_ = nodes_ = 0.0;
  held_.clear();
}

template <class L>
double Enclosed<L>::hold(const Slots<L> &f, const Cover &cover, Neighbours &neighbours) const
{
  const int32_t *owner = cover.owner();
  enum { EXCESS, NODES, AROUND, WEIGHT, SIZE };    // of the fluid, and of the spheres around it
  std::vector<std::array<double, SIZE>> sums(held_.size());
  std::vector<double> between;
  for (std::size_t k = 0; k < held_.size(); k++) {
    auto &sum = sums[k];
    sum = {};
    for (const Index n : held_[k].nodes) {
      if (owner[n] >= 0) continue;
      sum[NODES] += 1.0;
      for (int i = 0; i < L::Q; i++) {
        sum[EXCESS] += f[i][n];
        const int32_t s = owner[n + at_.offset(L::e[i])];
        if (s < 0 || cover.is_obstacle(s)) continue;
        sum[AROUND] += L::w[i] * cover.spheres()[s].drho;
        sum[WEIGHT] += L::w[i];
      }
    }
    if (held_[k].shared) between.insert(between.end(), sum.begin(), sum.end());
  }
  if (!between.empty()) neighbours.sum(between.data(), int(between.size()));
  auto whole = between.begin();
  double gain = 0.0;
  for (std::size_t k = 0; k < held_.size(); k++) {
    auto &sum = sums[k];
    if (held_[k].shared) {
      std::copy_n(whole, int(SIZE), sum.begin());
      whole += SIZE;
    }
    if (sum[NODES] == 0.0 || sum[WEIGHT] == 0.0) continue;
    const double shift = sum[AROUND] / sum[WEIGHT] - sum[EXCESS] / sum[NODES];
    for (const Index n : held_[k].nodes) {
      if (owner[n] >= 0) continue;
      for (int i = 0; i < L::Q; i++) f[i][n] = typename L::Real(f[i][n] + L::w[i] * shift);
      gain += shift;
    }
  }
  return gain;
}

template <class L> double Enclosed<L>::bytes() const
{
  double sum = double(held_.capacity() * sizeof(Set));
  for (const Set &set : held_) sum += double(set.nodes.capacity() * sizeof(uint32_t));
  return sum;
}

#define LBM_INSTANTIATE(L) template class Enclosed<L>;
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
