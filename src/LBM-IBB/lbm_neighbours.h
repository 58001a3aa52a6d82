// SPDX-License-Identifier: GPL-2.0-only
// What lies across the faces of a block, and how to talk to it: the only door to other ranks.

#ifndef LBM_NEIGHBOURS_H
#define LBM_NEIGHBOURS_H

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace lbm {

class Neighbours {
 public:
  virtual ~Neighbours() = default;

  // is there a block (maybe this one again) below (side 0) or above (side 1) along dimension d?
  virtual bool exists(int d, int side) const = 0;

  // is this block its own neighbour on both sides along d?
  virtual bool itself(int d) const = 0;

  // Send to the neighbour on this side, and receive from the one on the other side what it sends.
  // Where there is no neighbour nothing is sent or received. All blocks of a row call it together.
  // Numbers have 4 bytes or 8.
  template <class T>
  void shift(int d, int side, const T *send, std::size_t nsend, T *receive, std::size_t nreceive)
  {
    static_assert(std::is_arithmetic_v<T> && sizeof(T) % 4 == 0);
    shift_words(d, side, send, nsend * sizeof(T) / 4, receive, nreceive * sizeof(T) / 4);
  }

  // over all blocks, in place
  virtual void sum(double *values, int n) = 0;
  virtual void max(double *values, int n) = 0;
  // what all blocks have, one after the other, in the same order on all
  virtual std::vector<double> gather(const std::vector<double> &mine) = 0;

 protected:
  // sizes in words of 4 bytes
  virtual void shift_words(int d, int side, const void *send, std::size_t nsend, void *receive,
                           std::size_t nreceive) = 0;
};

// one block that is its own neighbour in periodic directions
class Alone : public Neighbours {
 public:
  explicit Alone(const std::array<bool, 3> &periodic) : periodic_(periodic) {}
  bool exists(int d, int) const override { return periodic_[d]; }
  bool itself(int d) const override { return periodic_[d]; }
  void sum(double *, int) override {}
  void max(double *, int) override {}
  std::vector<double> gather(const std::vector<double> &mine) override { return mine; }

 private:
  void shift_words(int d, int side, const void *send, std::size_t nsend, void *receive,
                   std::size_t nreceive) override;
  std::array<bool, 3> periodic_;
};

}    // namespace lbm
#endif
