// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace galilean::monitor {

/// The state vector of the filter and its covariance: one normal distribution over all that is
/// estimated together. The vector consists of blocks, one for each robot and each landmark, that
/// come and go. The covariance between blocks tells which errors they share, so that a measurement
/// of one corrects all others that depend on it.
///   cost    n² for `correct` and `remove`, n for all else, where n is the length of the vector.
///           Storage is doubled when it is full, so that adding a block seldom copies
///   source  the extended Kalman filter for stochastic maps (Smith, Self, Cheeseman 1990)
class JointGaussian {
 public:
  /// The longest block, and the largest dimension of a measurement.
  static constexpr int kMaxSize = 7;

  using Block = std::uint32_t;  ///< names a block as long as it is not removed
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxSize, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxSize, kMaxSize>;

  /// One summand of a linear function of the state: `jacobian` times the first numbers of `block`,
  /// as many as the Jacobian has columns.
  struct Term {
    Block block;
    Matrix jacobian;
  };
  using Terms = std::span<const Term>;

  /// Appends a block that is independent of all others.
  Block add(const Vector& mean, const Matrix& covariance);
  /// Appends a block that is a function of other blocks, linearized as the sum over `of`, with
  /// independent `noise` (a covariance). This is state augmentation.
  Block add(const Vector& mean, Terms of, const Matrix& noise);
  /// Marginalizes a block out. Its name may be given to a later block.
  void remove(Block block);

  [[nodiscard]] Vector mean(Block block) const;
  /// Returns the first two numbers of the block's mean: its position in the map frame [m].
  [[nodiscard]] Eigen::Vector2d position(Block block) const;
  [[nodiscard]] Matrix covariance(Block block) const;
  /// Returns the covariance of the sum over `terms`. Requires: Jacobians with as many rows each.
  [[nodiscard]] Matrix covariance(Terms terms) const;

  /// Returns the covariance between the first kRows numbers of one block and the first kColumns of
  /// another.
  template <int kRows, int kColumns>
  [[nodiscard]] Eigen::Matrix<double, kRows, kColumns> cross_covariance(Block rows,
                                                                        Block columns) const {
    const Eigen::Index i = slice(rows).at, j = slice(columns).at;
    if (i >= j) return covariance_.block<kRows, kColumns>(i, j);
    return covariance_.block<kColumns, kRows>(j, i).transpose();
  }

  /// Replaces a block by a function of itself that has this value and Jacobian, plus independent
  /// `noise` (a covariance). This is the filter's prediction step.
  void transform(Block block, const Vector& mean, const Matrix& jacobian, const Matrix& noise);
  /// Replaces one number of a block by one that is independent of all others.
  void reset_component(Block block, Eigen::Index component, double mean, double variance);
  /// Adds independent noise to a block, given as a covariance.
  void inflate(Block block, const Matrix& noise);
  /// Adds one unknown of this covariance that several blocks share through their Jacobians.
  void inflate(Terms shared, const Matrix& covariance);
  /// Takes a measurement of the sum over `terms` in: it came out `innovation` larger than
  /// predicted, and its own error has the covariance `noise`. This is the filter's correction step.
  void correct(Terms terms, const Vector& innovation, const Matrix& noise);

 private:
  /// The place of a block in the state vector.
  struct Slice {
    Eigen::Index at = 0, size = 0;
  };
  /// As many rows as the state vector, and a column for each number of a sum over terms.
  using Cross = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, kMaxSize>;

  [[nodiscard]] const Slice& slice(Block block) const { return slices_[block]; }
  /// Returns the covariance of the whole state with the sum over `terms`.
  [[nodiscard]] Cross cross_covariance(Terms terms) const;
  [[nodiscard]] Matrix apply(Terms terms, const Cross& cross) const;
  Block append(const Vector& mean);
  void reserve(Eigen::Index size);

  std::vector<Slice> slices_;  ///< by block
  std::vector<Block> unused_;  ///< names of blocks that were removed
  Eigen::Index size_ = 0;      ///< length of the state vector; the storage below may be longer
  Eigen::VectorXd mean_;
  /// The lower half of the covariance, and both halves of each block's own part. What is above
  /// those has no meaning.
  Eigen::MatrixXd covariance_;
};

}  // namespace galilean::monitor
