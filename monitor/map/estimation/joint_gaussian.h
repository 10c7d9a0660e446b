#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace galilean::monitor {

/// One normal distribution over all that is estimated together, in parts that come and go: robots
/// and landmarks. It keeps what their errors have in common, so that whoever learns where it is
/// tells all that hangs on it.
///   cost    of n numbers in all: n² for `correct` and `remove`, n for the rest. Room is made by
///           doubling, so that what comes and goes copies nothing
///   source  the extended Kalman filter for maps (Smith, Self, Cheeseman 1990)
class JointGaussian {
 public:
  static constexpr int kMostNumbers = 7;  ///< that a part has, or a sum over terms

  using Part = std::uint32_t;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostNumbers, 1>;
  using Matrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostNumbers, kMostNumbers>;

  /// A linear dependence on a part's first numbers, as many as the Jacobian has columns.
  struct Term {
    Part part;
    Matrix jacobian;
  };
  using Terms = std::span<const Term>;

  /// Independent of all others.
  Part add(const Vector& mean, const Matrix& covariance);
  /// A function of other parts: its value, what it makes of their errors, and noise of its own.
  Part add(const Vector& mean, Terms of, const Matrix& noise);
  void remove(Part part);

  [[nodiscard]] Vector mean(Part part) const;
  /// The mean's first two numbers.
  [[nodiscard]] Eigen::Vector2d position(Part part) const;
  [[nodiscard]] Matrix covariance(Part part) const;
  /// Of the sum over `terms`.
  [[nodiscard]] Matrix covariance(Terms terms) const;

  /// Between a part's first numbers and another's, as many as are asked for.
  template <int kRows, int kColumns>
  [[nodiscard]] Eigen::Matrix<double, kRows, kColumns> cross_covariance(Part rows,
                                                                        Part columns) const {
    const Eigen::Index i = place(rows).at, j = place(columns).at;
    if (i >= j) return covariance_.block<kRows, kColumns>(i, j);
    return covariance_.block<kColumns, kRows>(j, i).transpose();
  }

  /// The part becomes a function of itself, with this value and Jacobian, plus noise.
  void move(Part part, const Vector& mean, const Matrix& jacobian, const Matrix& noise);
  /// One number of a part is something else from now on, independent of all.
  void replace(Part part, Eigen::Index component, double mean, double variance);
  /// Adds independent noise.
  void blur(Part part, const Matrix& noise);
  /// Adds one unknown that all the parts share.
  void blur(Terms shared, const Matrix& covariance);
  /// The sum over `terms` was measured `innovation` larger than expected, with this noise.
  void correct(Terms terms, const Vector& innovation, const Matrix& noise);

 private:
  struct Place {
    Eigen::Index at = 0, size = 0;
  };
  /// A row for each number of all, a column for each of a sum's or a part's.
  using Cross =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, kMostNumbers>;

  [[nodiscard]] const Place& place(Part part) const { return places_[part]; }
  /// Covariance of everything with the sum over `terms`.
  [[nodiscard]] Cross cross_covariance(Terms terms) const;
  [[nodiscard]] Matrix apply(Terms terms, const Cross& cross) const;
  Part append(const Vector& mean);
  void make_room(Eigen::Index size);

  std::vector<Place> places_;
  std::vector<Part> unused_;  ///< parts that were removed
  Eigen::Index size_ = 0;     ///< what of the following is in use
  Eigen::VectorXd mean_;
  /// Its lower half; of each part's own block both halves, and above that nothing of use.
  Eigen::MatrixXd covariance_;
};

}  // namespace galilean::monitor
