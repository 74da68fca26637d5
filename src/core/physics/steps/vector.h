// Vectors, matrices and quaternions of any type of number, for steps. Sums are in Eigen's order:
// whether a vector is Eigen's or one of these, it has the same bits.
#pragma once

namespace rotatebook::physics {

template <typename Number>
struct Vector3 {
  Number x, y, z;
};

template <typename Number>
Vector3<Number> operator+(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Number>
Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Number>
Vector3<Number> operator*(Number factor, const Vector3<Number>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
template <typename Number>
Vector3<Number> operator/(const Vector3<Number>& v, Number divisor) {
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}
/// Returns the products of the components.
template <typename Number>
Vector3<Number> componentProduct(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <typename Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <typename Number>
Number squaredNorm(const Vector3<Number>& v) {
  return dot(v, v);
}
/// Returns, body by body, `yes` where `condition` holds and else `no`.
template <typename Condition, typename Number>
Vector3<Number> chosen(const Condition& condition, const Vector3<Number>& yes,
                       const Vector3<Number>& no) {
  return {chosen(condition, yes.x, no.x), chosen(condition, yes.y, no.y),
          chosen(condition, yes.z, no.z)};
}
/// Returns whether all three components are finite.
template <typename Number>
auto isFinite(const Vector3<Number>& v) {
  const Vector3<Number> none = v - v;
  return none.x + (none.y + none.z) == Number(0);
}
/// Returns whether the sizes of all components are below `bound`.
template <typename Number>
auto isWithin(const Vector3<Number>& v, double bound) {
  const Number most(bound);
  return both(magnitude(v.x) < most, both(magnitude(v.y) < most, magnitude(v.z) < most));
}
/// Returns the largest size of a component, which must not be NaN.
template <typename Number>
Number largestSize(const Vector3<Number>& v) {
  const Number x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
  const Number other = chosen(y < z, z, y);
  return chosen(x < other, other, x);
}

/// A matrix, by its columns.
template <typename Number>
struct Matrix3 {
  Vector3<Number> x, y, z;
};

template <typename Condition, typename Number>
Matrix3<Number> chosen(const Condition& condition, const Matrix3<Number>& yes,
                       const Matrix3<Number>& no) {
  return {chosen(condition, yes.x, no.x), chosen(condition, yes.y, no.y),
          chosen(condition, yes.z, no.z)};
}
template <typename Number>
Vector3<Number> product(const Matrix3<Number>& m, const Vector3<Number>& v) {
  return {dot({m.x.x, m.y.x, m.z.x}, v), dot({m.x.y, m.y.y, m.z.y}, v),
          dot({m.x.z, m.y.z, m.z.z}, v)};
}
/// Returns the product of the transposed matrix.
template <typename Number>
Vector3<Number> transposedProduct(const Matrix3<Number>& m, const Vector3<Number>& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

template <typename Number>
struct Quaternion {
  Number w, x, y, z;

  Vector3<Number> vec() const { return {x, y, z}; }
};

template <typename Number>
Quaternion<Number> operator*(const Quaternion<Number>& a, const Quaternion<Number>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}
template <typename Number>
Number squaredNorm(const Quaternion<Number>& q) {
  return (q.x * q.x + q.y * q.y) + (q.z * q.z + q.w * q.w);
}
/// Returns q + factor * other, component by component.
template <typename Number>
Quaternion<Number> addScaled(const Quaternion<Number>& q, Number factor,
                             const Quaternion<Number>& other) {
  return {q.w + factor * other.w, q.x + factor * other.x, q.y + factor * other.y,
          q.z + factor * other.z};
}
/// Returns `q` times the factor.
template <typename Number>
Quaternion<Number> scaled(const Quaternion<Number>& q, Number factor) {
  return {q.w * factor, q.x * factor, q.y * factor, q.z * factor};
}
/// Returns (1, v), normalised.
template <typename Number>
Quaternion<Number> unitFromHalfTangent(const Vector3<Number>& v) {
  const Quaternion<Number> q{Number(1), v.x, v.y, v.z};
  const Number norm = rootOf(squaredNorm(q));
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

}  // namespace rotatebook::physics
