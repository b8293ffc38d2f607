// SPDX-License-Identifier: MIT
#pragma once

// Variant, and every type that one may hold. One header, because the types refer to one another.

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/core/engine_interface.hpp>
#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/char_string.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/plane.hpp>
#include <godot_cpp/variant/projection.hpp>
#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/rect2i.hpp>
#include <godot_cpp/variant/transform2d.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace godot {

class Object;
class Variant;
template <class T>
class Ref;

/// A set of flags.
template <class T>
class BitField {
public:
	constexpr BitField() = default;
	constexpr BitField(T p_flag) : value(int64_t(p_flag)) {}
	constexpr BitField(int64_t p_value) : value(p_value) {}
	constexpr operator int64_t() const { return value; }
	constexpr bool has_flag(T p_flag) const { return (value & int64_t(p_flag)) != 0; }
	void set_flag(T p_flag) { value |= int64_t(p_flag); }
	void clear_flag(T p_flag) { value &= ~int64_t(p_flag); }

private:
	int64_t value = 0;
};

namespace internal {

/// Asks for a value that the engine will construct in place.
struct Uninitialized {};
constexpr Uninitialized uninitialized;

void make_variant(GDExtensionVariantType p_type, void *r_variant, const void *p_value);
void read_variant(GDExtensionVariantType p_type, void *r_value, const void *p_variant);

} // namespace internal

#include <godot_cpp/variant/builtin_types.inc>

/// Any value.
class Variant {
public:
	// All bytes zero is null.
	alignas(8) uint8_t opaque[24] = {};

#include <godot_cpp/variant/variant_enums.inc>

	Variant() = default;
	Variant(const Variant &p_other) { internal::engine.variant_new_copy(opaque, p_other.opaque); }
	Variant(Variant &&p_other) noexcept { std::swap(opaque, p_other.opaque); }
	Variant(std::nullptr_t) {}
	Variant(bool p_value);
	template <class T,
			std::enable_if_t<(std::is_integral_v<T> || std::is_enum_v<T>) && !std::is_same_v<T, bool>, int> = 0>
	Variant(T p_value) {
		const int64_t value = int64_t(p_value);
		internal::make_variant(GDEXTENSION_VARIANT_TYPE_INT, opaque, &value);
	}
	Variant(double p_value) { internal::make_variant(GDEXTENSION_VARIANT_TYPE_FLOAT, opaque, &p_value); }
	Variant(float p_value) : Variant(double(p_value)) {}
	template <class T>
	Variant(BitField<T> p_flags) : Variant(int64_t(p_flags)) {}
	Variant(const char *p_text) : Variant(String(p_text)) {}
	Variant(const Object *p_object);
	template <class T>
	Variant(const Ref<T> &p_reference) : Variant(static_cast<const Object *>(p_reference.ptr())) {}
	~Variant() { internal::engine.variant_destroy(opaque); }

	Variant &operator=(const Variant &p_other);
	Variant &operator=(Variant &&p_other) noexcept {
		std::swap(opaque, p_other.opaque);
		return *this;
	}

	operator bool() const { return booleanize(); }
	operator int64_t() const;
	operator int32_t() const { return int32_t(operator int64_t()); }
	operator uint64_t() const { return uint64_t(operator int64_t()); }
	operator uint32_t() const { return uint32_t(operator int64_t()); }
	operator double() const;
	operator float() const { return float(operator double()); }
	operator Object *() const;
#include <godot_cpp/variant/variant_conversions.inc>

	Type get_type() const { return Type(internal::engine.variant_get_type(opaque)); }
	static String get_type_name(Type p_type);
	static bool can_convert_strict(Type p_from, Type p_to);
	bool booleanize() const { return internal::engine.variant_booleanize(opaque) != 0; }
	String stringify() const;
	bool operator==(const Variant &p_other) const { return compare(OP_EQUAL, p_other); }
	bool operator!=(const Variant &p_other) const { return compare(OP_NOT_EQUAL, p_other); }
	bool operator<(const Variant &p_other) const { return compare(OP_LESS, p_other); }

private:
	bool compare(Operator p_operator, const Variant &p_other) const;
};

#include <godot_cpp/variant/builtin_varargs.inc>

/// The builtin type that a C++ type is, if any.
template <class T>
struct BuiltinType {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_NIL;
};
#include <godot_cpp/variant/builtin_traits.inc>

template <class T>
constexpr bool is_builtin_v = BuiltinType<T>::type != GDEXTENSION_VARIANT_TYPE_NIL;

inline String operator+(const char *p_left, const String &p_right) {
	return String(p_left) + p_right;
}

/// Text with placeholders as in GDScript's % operator.
template <class... Arguments>
String vformat(const String &p_text, const Arguments &...p_arguments) {
	return p_text % Array::make(p_arguments...);
}

} // namespace godot
