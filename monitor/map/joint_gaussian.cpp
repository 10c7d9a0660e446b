#include "monitor/map/joint_gaussian.h"

#include <Eigen/Cholesky>

namespace galilean::monitor {

JointGaussian::Part JointGaussian::append(const Vector& mean) {
  const Eigen::Index at = mean_.size(), size = mean.size(), all = at + size;
  mean_.conservativeResize(all);
  covariance_.conservativeResize(all, all);
  mean_.tail(size) = mean;
  covariance_.rightCols(size).setZero();
  covariance_.bottomRows(size).setZero();
  places_[++last_part_] = {at, size};
  return last_part_;
}

JointGaussian::Part JointGaussian::add(const Vector& mean, const Matrix& covariance) {
  const Part part = append(mean);
  blur(part, covariance);
  return part;
}

JointGaussian::Part JointGaussian::add(const Vector& mean, const Terms& of, const Matrix& noise) {
  const Matrix cross = cross_covariance(of);
  const Matrix own = apply(of, cross);
  const Part part = append(mean);
  const auto [at, size] = place(part);
  covariance_.block(0, at, at, size) = cross;
  covariance_.block(at, 0, size, at) = cross.transpose();
  covariance_.block(at, at, size, size) = own + noise;
  return part;
}

void JointGaussian::remove(Part part) {
  const auto [at, size] = place(part);
  const Eigen::Index after = at + size, rest = mean_.size() - after, left = mean_.size() - size;
  mean_.segment(at, rest) = mean_.tail(rest).eval();
  covariance_.middleRows(at, rest) = covariance_.bottomRows(rest).eval();
  covariance_.middleCols(at, rest) = covariance_.rightCols(rest).eval();
  mean_.conservativeResize(left);
  covariance_.conservativeResize(left, left);
  places_.erase(part);
  for (auto& [other, where] : places_)
    if (where.at > at) where.at -= size;
}

JointGaussian::Vector JointGaussian::mean(Part part) const {
  const auto [at, size] = place(part);
  return mean_.segment(at, size);
}

JointGaussian::Matrix JointGaussian::covariance(Part part) const {
  const auto [at, size] = place(part);
  return covariance_.block(at, at, size, size);
}

JointGaussian::Matrix JointGaussian::covariance(const Terms& terms) const {
  Matrix sum;
  for (const auto& a : terms)
    for (const auto& b : terms) {
      const auto& [row, rows] = place(a.part);
      const auto& [column, columns] = place(b.part);
      const Matrix share =
          a.jacobian * covariance_.block(row, column, rows, columns) * b.jacobian.transpose();
      sum = sum.size() ? Matrix(sum + share) : share;
    }
  return sum;
}

JointGaussian::Matrix JointGaussian::cross_covariance(const Terms& terms) const {
  Matrix cross = Matrix::Zero(mean_.size(), terms.front().jacobian.rows());
  for (const auto& [part, jacobian] : terms) {
    const auto [at, size] = place(part);
    cross.noalias() += covariance_.middleCols(at, size) * jacobian.transpose();
  }
  return cross;
}

JointGaussian::Matrix JointGaussian::apply(const Terms& terms, const Matrix& cross) const {
  Matrix sum = Matrix::Zero(cross.cols(), cross.cols());
  for (const auto& [part, jacobian] : terms) {
    const auto [at, size] = place(part);
    sum += jacobian * cross.middleRows(at, size);
  }
  return sum;
}

void JointGaussian::move(Part part, const Vector& mean, const Matrix& jacobian,
                         const Matrix& noise) {
  const auto [at, size] = place(part);
  mean_.segment(at, size) = mean;
  covariance_.middleRows(at, size) = (jacobian * covariance_.middleRows(at, size)).eval();
  covariance_.middleCols(at, size) =
      (covariance_.middleCols(at, size) * jacobian.transpose()).eval();
  blur(part, noise);
}

void JointGaussian::replace(Part part, Eigen::Index component, double mean, double variance) {
  const Eigen::Index at = place(part).at + component;
  mean_[at] = mean;
  covariance_.row(at).setZero();
  covariance_.col(at).setZero();
  covariance_(at, at) = variance;
}

void JointGaussian::blur(Part part, const Matrix& noise) {
  const auto [at, size] = place(part);
  covariance_.block(at, at, size, size) += noise;
}

void JointGaussian::blur(const Terms& shared, const Matrix& covariance) {
  for (const auto& a : shared)
    for (const auto& b : shared) {
      const auto& [row, rows] = place(a.part);
      const auto& [column, columns] = place(b.part);
      covariance_.block(row, column, rows, columns) +=
          a.jacobian * covariance * b.jacobian.transpose();
    }
}

void JointGaussian::correct(const Terms& terms, const Vector& innovation, const Matrix& noise) {
  const Matrix cross = cross_covariance(terms);
  const Matrix sum = apply(terms, cross) + noise;
  const Matrix gain = sum.ldlt().solve(cross.transpose()).transpose();
  mean_.noalias() += gain * innovation;
  covariance_.noalias() -= gain * cross.transpose();
  // Rounding would let the two halves drift apart.
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

}  // namespace galilean::monitor
