// SPDX-License-Identifier: MIT
#pragma once

// Variant and every builtin type, in one header because they all mention one another.
#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/core/engine_interface.hpp>
#include <godot_cpp/variant/char_string.hpp>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <new>
#include <type_traits>
#include <utility>

namespace godot {

class Object;
class Variant;
template <class T>
class Ref;

/// A set of flags from the enum T.
template <class T>
class BitField {
public:
	BitField(T p_flag) : value(static_cast<int64_t>(p_flag)) {}
	BitField(int64_t p_flags = 0) : value(p_flags) {}
	operator int64_t() const { return value; }
	bool has_flag(T p_flag) const { return (value & static_cast<int64_t>(p_flag)) != 0; }
	void set_flag(T p_flag) { value |= static_cast<int64_t>(p_flag); }

private:
	int64_t value;
};

namespace internal {

// Declared before the types of which they make use, for templates in the bodies of those types.
GDExtensionPtrBuiltInMethod builtin_method(GDExtensionVariantType p_type, const char *p_name, int64_t p_hash);
template <class R, class... Arguments>
R call_builtin(GDExtensionPtrBuiltInMethod p_function, void *p_base, const Arguments &...p_arguments);
template <class T>
Variant to_variant(const T &p_value);

template <class T, class...>
struct DependentType {
	using type = T;
};

/// T itself, but looked at only when the template is instantiated.
template <class T, class... Arguments>
using Dependent = typename DependentType<T, Arguments...>::type;

} // namespace internal

// Memberwise arithmetic of a vector type with m_count components.
#define GODOT_VECTOR_OPERATORS(m_vector, m_scalar, m_count) \
	m_scalar &operator[](int p_axis) { \
		return (&x)[p_axis]; \
	} \
	const m_scalar &operator[](int p_axis) const { \
		return (&x)[p_axis]; \
	} \
	m_vector operator+(const m_vector &p_other) const { \
		m_vector result = *this; \
		return result += p_other; \
	} \
	m_vector operator-(const m_vector &p_other) const { \
		m_vector result = *this; \
		return result -= p_other; \
	} \
	m_vector operator*(const m_vector &p_other) const { \
		m_vector result; \
		for (int i = 0; i < (m_count); i++) { \
			result[i] = (*this)[i] * p_other[i]; \
		} \
		return result; \
	} \
	m_vector operator*(m_scalar p_scale) const { \
		m_vector result = *this; \
		return result *= p_scale; \
	} \
	m_vector operator/(m_scalar p_divisor) const { \
		m_vector result; \
		for (int i = 0; i < (m_count); i++) { \
			result[i] = (*this)[i] / p_divisor; \
		} \
		return result; \
	} \
	m_vector operator-() const { \
		return *this * m_scalar(-1); \
	} \
	m_vector &operator+=(const m_vector &p_other) { \
		for (int i = 0; i < (m_count); i++) { \
			(*this)[i] += p_other[i]; \
		} \
		return *this; \
	} \
	m_vector &operator-=(const m_vector &p_other) { \
		for (int i = 0; i < (m_count); i++) { \
			(*this)[i] -= p_other[i]; \
		} \
		return *this; \
	} \
	m_vector &operator*=(m_scalar p_scale) { \
		for (int i = 0; i < (m_count); i++) { \
			(*this)[i] *= p_scale; \
		} \
		return *this; \
	} \
	bool operator==(const m_vector &p_other) const { \
		for (int i = 0; i < (m_count); i++) { \
			if ((*this)[i] != p_other[i]) { \
				return false; \
			} \
		} \
		return true; \
	} \
	bool operator!=(const m_vector &p_other) const { \
		return !(*this == p_other); \
	}

#include <godot_cpp/variant/builtins.inc>

/// Holds a value of any type that the engine knows.
class Variant {
public:
#include <godot_cpp/variant/variant_enums.inc>

	alignas(8) uint8_t opaque[24] = {}; // All zero is NIL.

	Variant() = default;
	Variant(const Variant &p_other) { internal::engine.variant_new_copy(opaque, p_other.opaque); }
	Variant(Variant &&p_other) noexcept { std::swap(opaque, p_other.opaque); }
	~Variant() { internal::engine.variant_destroy(opaque); }
	Variant &operator=(Variant p_other) noexcept {
		std::swap(opaque, p_other.opaque);
		return *this;
	}

	Variant(bool p_value);
	template <class T,
			std::enable_if_t<(std::is_integral_v<T> || std::is_enum_v<T>) && !std::is_same_v<T, bool>, int> = 0>
	Variant(T p_value) {
		set_integer(static_cast<int64_t>(p_value));
	}
	Variant(double p_value);
	Variant(float p_value) : Variant(static_cast<double>(p_value)) {}
	Variant(const char *p_utf8) : Variant(String(p_utf8)) {}
	Variant(const Object *p_object);
	template <class T>
	Variant(const Ref<T> &p_reference) : Variant(static_cast<const Object *>(p_reference.ptr())) {}

	operator bool() const;
	operator int64_t() const;
	operator int32_t() const { return static_cast<int32_t>(operator int64_t()); }
	operator double() const;
	operator float() const { return static_cast<float>(operator double()); }
	operator Object *() const;

#include <godot_cpp/variant/variant_conversions.inc>

	Type get_type() const { return static_cast<Type>(internal::engine.variant_get_type(opaque)); }
	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const { return !(*this == p_other); }
	String stringify() const;

private:
	void set_integer(int64_t p_value);
};

/// The Variant type of a builtin type; NIL for every other type.
template <class T>
struct BuiltinType {
	static constexpr GDExtensionVariantType value = GDEXTENSION_VARIANT_TYPE_NIL;
};

#include <godot_cpp/variant/builtin_types.inc>

} // namespace godot

#include <godot_cpp/core/builtin_call.hpp>
