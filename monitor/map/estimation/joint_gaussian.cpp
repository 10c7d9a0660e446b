#include "monitor/map/estimation/joint_gaussian.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace galilean::monitor {

void JointGaussian::make_room(Eigen::Index size) {
  if (size <= mean_.size()) return;
  const Eigen::Index room = std::max(size, 2 * mean_.size());
  mean_.conservativeResize(room);
  covariance_.conservativeResize(room, room);
}

JointGaussian::Part JointGaussian::append(const Vector& mean) {
  const Place added{size_, mean.size()};
  make_room(size_ + added.size);
  size_ += added.size;
  mean_.segment(added.at, added.size) = mean;
  covariance_.block(added.at, 0, added.size, size_).setZero();
  if (unused_.empty()) {
    places_.push_back(added);
    return static_cast<Part>(places_.size() - 1);
  }
  const Part part = unused_.back();
  unused_.pop_back();
  places_[part] = added;
  return part;
}

JointGaussian::Part JointGaussian::add(const Vector& mean, const Matrix& covariance) {
  const Part part = append(mean);
  blur(part, covariance);
  return part;
}

JointGaussian::Part JointGaussian::add(const Vector& mean, Terms of, const Matrix& noise) {
  const Cross cross = cross_covariance(of);
  const Matrix own = apply(of, cross);
  const Part part = append(mean);
  const auto [at, size] = place(part);
  covariance_.block(at, 0, size, at) = cross.transpose();
  covariance_.block(at, at, size, size) = own + noise;
  return part;
}

void JointGaussian::remove(Part part) {
  const auto [at, size] = place(part);
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
  for (Place& other : places_)
    if (other.at > at) other.at -= size;
  places_[part] = {};
  unused_.push_back(part);
}

JointGaussian::Vector JointGaussian::mean(Part part) const {
  const auto [at, size] = place(part);
  return mean_.segment(at, size);
}

Eigen::Vector2d JointGaussian::position(Part part) const {
  return mean_.segment<2>(place(part).at);
}

JointGaussian::Matrix JointGaussian::covariance(Part part) const {
  const auto [at, size] = place(part);
  return covariance_.block(at, at, size, size);
}

JointGaussian::Matrix JointGaussian::covariance(Terms terms) const {
  const Eigen::Index size = terms.front().jacobian.rows();
  Matrix sum = Matrix::Zero(size, size);
  for (const auto& [row, of_row] : terms)
    for (const auto& [column, of_column] : terms) {
      const Eigen::Index i = place(row).at, j = place(column).at;
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
  for (const auto& [part, jacobian] : terms)
    for (Eigen::Index from = 0; from < jacobian.cols(); ++from) {
      const auto [at, size] = place(part);
      column.head(at) = covariance_.row(at + from).head(at);
      column.tail(size_ - at) = covariance_.col(at + from).segment(at, size_ - at);
      for (Eigen::Index to = 0; to < jacobian.rows(); ++to)
        if (jacobian(to, from) != 0) cross.col(to) += jacobian(to, from) * column;
    }
  return cross;
}

JointGaussian::Matrix JointGaussian::apply(Terms terms, const Cross& cross) const {
  Matrix sum = Matrix::Zero(cross.cols(), cross.cols());
  for (const auto& [part, jacobian] : terms)
    sum += jacobian * cross.middleRows(place(part).at, jacobian.cols());
  return sum;
}

void JointGaussian::move(Part part, const Vector& mean, const Matrix& jacobian,
                         const Matrix& noise) {
  const auto [at, size] = place(part);
  const Term itself[] = {{part, jacobian}};
  const Cross cross = cross_covariance(itself);
  const Matrix own = apply(itself, cross);
  mean_.segment(at, size) = mean;
  covariance_.block(at, 0, size, at) = cross.topRows(at).transpose();
  covariance_.block(at, at, size_ - at, size) = cross.bottomRows(size_ - at);
  covariance_.block(at, at, size, size) = own + noise;
}

void JointGaussian::replace(Part part, Eigen::Index component, double mean, double variance) {
  const auto [first, size] = place(part);
  const Eigen::Index at = first + component;
  mean_[at] = mean;
  covariance_.row(at).head(first + size).setZero();
  covariance_.col(at).segment(first, size_ - first).setZero();
  covariance_(at, at) = variance;
}

void JointGaussian::blur(Part part, const Matrix& noise) {
  const auto [at, size] = place(part);
  covariance_.block(at, at, size, size) += noise;
}

void JointGaussian::blur(Terms shared, const Matrix& covariance) {
  for (const auto& [row, of_row] : shared)
    for (const auto& [column, of_column] : shared)
      if (place(row).at >= place(column).at)
        covariance_.block(place(row).at, place(column).at, of_row.rows(), of_column.rows()) +=
            of_row * covariance * of_column.transpose();
}

/// With the noise's root taken out of both sides, what goes off the covariance is a square, and
/// stays symmetric to the last digit.
void JointGaussian::correct(Terms terms, const Vector& innovation, const Matrix& noise) {
  Cross cross = cross_covariance(terms);
  const Matrix sum = apply(terms, cross) + noise;
  const Eigen::LLT<Matrix> root(sum);
  root.matrixU().solveInPlace<Eigen::OnTheRight>(cross);
  const Vector whitened = root.matrixL().solve(innovation);
  mean_.head(size_).noalias() += cross * whitened;
  for (Eigen::Index column = 0; column < size_; ++column) {
    if (cross.row(column).isZero(0)) continue;  // it has nothing in common with these
    const Eigen::Index from = std::max<Eigen::Index>(column - kMostNumbers + 1, 0);
    auto numbers = covariance_.col(column).segment(from, size_ - from);
    if (cross.cols() == 2)  // nearly always: read and written once
      numbers = numbers - cross(column, 0) * cross.col(0).tail(size_ - from) -
                cross(column, 1) * cross.col(1).tail(size_ - from);
    else
      for (Eigen::Index i = 0; i < cross.cols(); ++i)
        numbers -= cross(column, i) * cross.col(i).tail(size_ - from);
  }
}

}  // namespace galilean::monitor
