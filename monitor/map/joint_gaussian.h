#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

namespace galilean::monitor {

/// One normal distribution over all that is estimated together, in parts that come and go: robots
/// and things. It keeps what their errors have in common, so that whoever learns where it is tells
/// all that hangs on it.
///   source  the extended Kalman filter for maps (Smith, Self, Cheeseman 1990)
class JointGaussian {
 public:
  using Part = std::uint32_t;
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;

  /// A linear dependence on one part.
  struct Term {
    Part part;
    Matrix jacobian;
  };
  using Terms = std::vector<Term>;

  /// Independent of all others.
  Part add(const Vector& mean, const Matrix& covariance);
  /// A function of other parts: its value, what it makes of their errors, and noise of its own.
  Part add(const Vector& mean, const Terms& of, const Matrix& noise);
  void remove(Part part);

  [[nodiscard]] Vector mean(Part part) const;
  [[nodiscard]] Matrix covariance(Part part) const;
  /// Of the sum over `terms`.
  [[nodiscard]] Matrix covariance(const Terms& terms) const;

  /// The part becomes a function of itself, with this value and Jacobian, plus noise.
  void move(Part part, const Vector& mean, const Matrix& jacobian, const Matrix& noise);
  /// One number of a part is something else from now on, independent of all.
  void replace(Part part, Eigen::Index component, double mean, double variance);
  /// Adds independent noise.
  void blur(Part part, const Matrix& noise);
  /// Adds one unknown that all the parts share.
  void blur(const Terms& shared, const Matrix& covariance);
  /// The sum over `terms` was measured `innovation` larger than expected, with this noise.
  void correct(const Terms& terms, const Vector& innovation, const Matrix& noise);

 private:
  struct Place {
    Eigen::Index at = 0, size = 0;
  };

  [[nodiscard]] const Place& place(Part part) const { return places_.at(part); }
  /// Covariance of everything with the sum over `terms`.
  [[nodiscard]] Matrix cross_covariance(const Terms& terms) const;
  [[nodiscard]] Matrix apply(const Terms& terms, const Matrix& cross) const;
  Part append(const Vector& mean);

  std::map<Part, Place> places_;
  Part last_part_ = 0;
  Vector mean_;
  Matrix covariance_;
};

}  // namespace galilean::monitor
