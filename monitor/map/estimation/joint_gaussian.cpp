// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/joint_gaussian.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace galilean::monitor {

void JointGaussian::reserve(Eigen::Index size) {
  if (size <= mean_.size()) return;
  const Eigen::Index room = std::max(size, 2 * mean_.size());
  mean_.conservativeResize(room);
  covariance_.conservativeResize(room, room);
}

JointGaussian::Block JointGaussian::append(const Vector& mean) {
  const Slice added{size_, mean.size()};
  reserve(size_ + added.size);
  size_ += added.size;
  mean_.segment(added.at, added.size) = mean;
  covariance_.block(added.at, 0, added.size, size_).setZero();
  if (unused_.empty()) {
    slices_.push_back(added);
    return static_cast<Block>(slices_.size() - 1);
  }
  const Block block = unused_.back();
  unused_.pop_back();
  slices_[block] = added;
  return block;
}

JointGaussian::Block JointGaussian::add(const Vector& mean, const Matrix& covariance) {
  const Block block = append(mean);
  inflate(block, covariance);
  return block;
}

JointGaussian::Block JointGaussian::add(const Vector& mean, Terms of, const Matrix& noise) {
  const Cross cross = cross_covariance(of);
  const Matrix own = apply(of, cross);
  const Block block = append(mean);
  const auto [at, size] = slice(block);
  covariance_.block(at, 0, size, at) = cross.transpose();
  covariance_.block(at, at, size, size) = own + noise;
  return block;
}

void JointGaussian::remove(Block block) {
  const auto [at, size] = slice(block);
  const Eigen::Index after = at + size;
  for (Eigen::Index to = at; to + size < size_; ++to) {
    mean_[to] = mean_[to + size];
    covariance_.col(to).head(size_) = covariance_.col(to + size).head(size_);
  }
  size_ -= size;
  for (Eigen::Index column = 0; column < size_; ++column) {
    double* numbers = covariance_.col(column).data();
    std::copy(numbers + after, numbers + size_ + size, numbers + at);
  }
  for (Slice& other : slices_)
    if (other.at > at) other.at -= size;
  slices_[block] = {};
  unused_.push_back(block);
}

JointGaussian::Vector JointGaussian::mean(Block block) const {
  const auto [at, size] = slice(block);
  return mean_.segment(at, size);
}

Eigen::Vector2d JointGaussian::position(Block block) const {
  return mean_.segment<2>(slice(block).at);
}

JointGaussian::Matrix JointGaussian::covariance(Block block) const {
  const auto [at, size] = slice(block);
  return covariance_.block(at, at, size, size);
}

JointGaussian::Matrix JointGaussian::covariance(Terms terms) const {
  const Eigen::Index size = terms.front().jacobian.rows();
  Matrix sum = Matrix::Zero(size, size);
  for (const auto& [row, of_row] : terms)
    for (const auto& [column, of_column] : terms) {
      const Eigen::Index i = slice(row).at, j = slice(column).at;
      if (i >= j)
        sum += of_row * covariance_.block(i, j, of_row.cols(), of_column.cols()) *
               of_column.transpose();
      else
        sum += of_row * covariance_.block(j, i, of_column.cols(), of_row.cols()).transpose() *
               of_column.transpose();
    }
  return sum;
}

JointGaussian::Cross JointGaussian::cross_covariance(Terms terms) const {
  Cross cross = Cross::Zero(size_, terms.front().jacobian.rows());
  Eigen::Matrix<double, Eigen::Dynamic, 1> column(size_);
  for (const auto& [block, jacobian] : terms)
    for (Eigen::Index from = 0; from < jacobian.cols(); ++from) {
      const auto [at, size] = slice(block);
      column.head(at) = covariance_.row(at + from).head(at);
      column.tail(size_ - at) = covariance_.col(at + from).segment(at, size_ - at);
      for (Eigen::Index to = 0; to < jacobian.rows(); ++to)
        if (jacobian(to, from) != 0) cross.col(to) += jacobian(to, from) * column;
    }
  return cross;
}

JointGaussian::Matrix JointGaussian::apply(Terms terms, const Cross& cross) const {
  Matrix sum = Matrix::Zero(cross.cols(), cross.cols());
  for (const auto& [block, jacobian] : terms)
    sum += jacobian * cross.middleRows(slice(block).at, jacobian.cols());
  return sum;
}

void JointGaussian::transform(Block block, const Vector& mean, const Matrix& jacobian,
                              const Matrix& noise) {
  const auto [at, size] = slice(block);
  const Term itself[] = {{block, jacobian}};
  const Cross cross = cross_covariance(itself);
  const Matrix own = apply(itself, cross);
  mean_.segment(at, size) = mean;
  covariance_.block(at, 0, size, at) = cross.topRows(at).transpose();
  covariance_.block(at, at, size_ - at, size) = cross.bottomRows(size_ - at);
  covariance_.block(at, at, size, size) = own + noise;
}

void JointGaussian::reset_component(Block block, Eigen::Index component, double mean,
                                    double variance) {
  const auto [first, size] = slice(block);
  const Eigen::Index at = first + component;
  mean_[at] = mean;
  covariance_.row(at).head(first + size).setZero();
  covariance_.col(at).segment(first, size_ - first).setZero();
  covariance_(at, at) = variance;
}

void JointGaussian::inflate(Block block, const Matrix& noise) {
  const auto [at, size] = slice(block);
  covariance_.block(at, at, size, size) += noise;
}

void JointGaussian::inflate(Terms shared, const Matrix& covariance) {
  for (const auto& [row, of_row] : shared)
    for (const auto& [column, of_column] : shared)
      if (slice(row).at >= slice(column).at)
        covariance_.block(slice(row).at, slice(column).at, of_row.rows(), of_column.rows()) +=
            of_row * covariance * of_column.transpose();
}

// Both sides are divided by the Cholesky root of the innovation covariance. The covariance then
// decreases by the product of a matrix with its own transpose, which is symmetric to the last
// digit.
void JointGaussian::correct(Terms terms, const Vector& innovation, const Matrix& noise) {
  Cross cross = cross_covariance(terms);
  const Matrix sum = apply(terms, cross) + noise;
  const Eigen::LLT<Matrix> root(sum);
  root.matrixU().solveInPlace<Eigen::OnTheRight>(cross);
  const Vector whitened = root.matrixL().solve(innovation);
  mean_.head(size_).noalias() += cross * whitened;
  for (Eigen::Index column = 0; column < size_; ++column) {
    if (cross.row(column).isZero(0)) continue;  // independent of the measurement
    const Eigen::Index from = std::max<Eigen::Index>(column - kMaxSize + 1, 0);
    auto numbers = covariance_.col(column).segment(from, size_ - from);
    if (cross.cols() == 2)  // the usual case takes one pass over the memory instead of two
      numbers = numbers - cross(column, 0) * cross.col(0).tail(size_ - from) -
                cross(column, 1) * cross.col(1).tail(size_ - from);
    else
      for (Eigen::Index i = 0; i < cross.cols(); ++i)
        numbers -= cross(column, i) * cross.col(i).tail(size_ - from);
  }
}

}  // namespace galilean::monitor
