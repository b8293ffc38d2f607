// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/type_info.hpp>

namespace godot {

/// An Array whose elements are all of one type; the engine checks it.
template <class T>
class TypedArray : public Array {
public:
	TypedArray() { internal::engine.array_set_typed(opaque, element_type(), element_class().opaque, Variant().opaque); }
	/// Shares an array of the same type, and copies (converting) any other.
	TypedArray(const Array &p_array) : TypedArray() {
		if (is_same_typed(p_array)) {
			Array::operator=(p_array);
		} else {
			assign(p_array);
		}
	}
	TypedArray(const Variant &p_array) : TypedArray(p_array.operator Array()) {}

private:
	// Elements of a class are named by it, not by the pointer type.
	using Element = std::conditional_t<std::is_base_of_v<Wrapped, T>, T *, T>;

	static GDExtensionVariantType element_type() { return TypeInfo<Element>::type; }
	static StringName element_class() { return TypeInfo<Element>::class_name(); }
};

template <class T>
struct TypeInfo<TypedArray<T>> {
	using Element = std::conditional_t<std::is_base_of_v<Wrapped, T>, T *, T>;
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_ARRAY;
	static StringName class_name() { return StringName(); }
	static PropertyInfo property() {
		const StringName element = TypeInfo<Element>::class_name();
		const String hint =
				element.is_empty() ? Variant::get_type_name(Variant::Type(TypeInfo<Element>::type)) : String(element);
		return PropertyInfo(Variant::ARRAY, "", PROPERTY_HINT_ARRAY_TYPE, hint);
	}
	static TypedArray<T> from_pointer(const void *p_value) { return *static_cast<const Array *>(p_value); }
	static void to_pointer(const TypedArray<T> &p_value, void *r_value) { *static_cast<Array *>(r_value) = p_value; }
	static TypedArray<T> from_variant(const Variant &p_value) { return p_value; }
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
};

} // namespace godot
