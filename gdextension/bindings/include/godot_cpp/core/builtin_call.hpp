// SPDX-License-Identifier: MIT
#pragma once

// How values cross into the engine and back, and calls of builtin types' methods. Included at the
// end of variant.hpp, when all types are complete.
#include <godot_cpp/variant/variant.hpp>

namespace godot {

/// An Array that only takes elements of the type T (a builtin type or an engine class).
template <class T>
class TypedArray : public Array {
public:
	TypedArray();
	/// Shares an array of the same type; copies the elements of any other, where they fit.
	TypedArray(const Array &p_array);
	TypedArray(const Variant &p_array) : TypedArray(p_array.operator Array()) {}
};

template <class T>
struct BuiltinType<TypedArray<T>> {
	static constexpr GDExtensionVariantType value = GDEXTENSION_VARIANT_TYPE_ARRAY;
};

template <class T>
constexpr bool is_builtin_v = BuiltinType<T>::value != GDEXTENSION_VARIANT_TYPE_NIL;

namespace internal {

template <class T>
Variant to_variant(const T &p_value) {
	return Variant(p_value);
}

template <class T>
void destroy(T &p_value) {
	p_value.~T();
}

template <class T, class = void>
struct HasPtr : std::false_type {};
template <class T>
struct HasPtr<T, std::void_t<decltype(std::declval<const T &>().ptr())>> : std::true_type {};

/// A value as the engine takes it by pointer: integers and enums widened to 64 bits, floats to
/// doubles, objects as pointers to the engine's half, builtin types where they lie.
template <class T>
class PtrArgument {
public:
	explicit PtrArgument(const T &p_value) {
		if constexpr (is_builtin_v<T> || std::is_same_v<T, Variant>) {
			pointer = &p_value;
		} else if constexpr (std::is_pointer_v<T>) {
			set_object(p_value);
		} else if constexpr (HasPtr<T>::value) {
			set_object(p_value.ptr());
		} else {
			scalar = static_cast<Scalar>(p_value);
		}
	}
	PtrArgument(const PtrArgument &) = delete;
	PtrArgument &operator=(const PtrArgument &) = delete;

	const void *get() const { return pointer != nullptr ? pointer : &scalar; }

private:
	using Scalar = std::conditional_t<std::is_same_v<T, bool>, uint8_t,
			std::conditional_t<std::is_floating_point_v<T>, double, int64_t>>;

	// A template, because Object is incomplete here.
	template <class O>
	void set_object(O *p_object) {
		scalar = p_object != nullptr ? reinterpret_cast<int64_t>(p_object->_owner) : 0;
	}

	const void *pointer = nullptr;
	Scalar scalar = {};
};

/// Where the engine puts a result, and what becomes of it.
template <class R, class = void>
struct PtrResult {
	R value;
	void *get() { return &value; }
	R take() { return std::move(value); }
};
template <class R>
struct PtrResult<R, std::enable_if_t<std::is_arithmetic_v<R> || std::is_enum_v<R>>> {
	using Wide = std::conditional_t<std::is_same_v<R, bool>, uint8_t,
			std::conditional_t<std::is_floating_point_v<R>, double, int64_t>>;
	Wide value = {};
	void *get() { return &value; }
	R take() { return static_cast<R>(value); }
};

/// Calls p_call with the addresses of the arguments (an array, ended by a null pointer).
template <class F, class... Arguments>
decltype(auto) with_addresses(const F &p_call, const PtrArgument<Arguments> &...p_arguments) {
	const void *addresses[] = { p_arguments.get()..., nullptr };
	return p_call(addresses);
}

template <class... Arguments>
void construct(GDExtensionPtrConstructor p_function, void *p_base, const Arguments &...p_arguments) {
	with_addresses(
			[&](const void **p_addresses) { p_function(p_base, p_addresses); }, PtrArgument<Arguments>(p_arguments)...);
}

template <class R, class... Arguments>
R call_builtin(GDExtensionPtrBuiltInMethod p_function, void *p_base, const Arguments &...p_arguments) {
	constexpr int count = sizeof...(Arguments);
	return with_addresses(
			[&](const void **p_addresses) -> R {
				if constexpr (std::is_void_v<R>) {
					p_function(p_base, p_addresses, nullptr, count);
				} else {
					PtrResult<R> result;
					p_function(p_base, p_addresses, result.get(), count);
					return result.take();
				}
			},
			PtrArgument<Arguments>(p_arguments)...);
}

template <class R, class Left, class Right>
R call_operator(GDExtensionPtrOperatorEvaluator p_function, const Left *p_left, const Right &p_right) {
	PtrResult<R> result;
	p_function(p_left, PtrArgument<Right>(p_right).get(), result.get());
	return result.take();
}

template <class R, class... Arguments>
R call_utility(GDExtensionPtrUtilityFunction p_function, const Arguments &...p_arguments) {
	constexpr int count = sizeof...(Arguments);
	return with_addresses(
			[&](const void **p_addresses) -> R {
				if constexpr (std::is_void_v<R>) {
					p_function(nullptr, p_addresses, count);
				} else {
					PtrResult<R> result;
					p_function(result.get(), p_addresses, count);
					return result.take();
				}
			},
			PtrArgument<Arguments>(p_arguments)...);
}

GDExtensionPtrUtilityFunction utility_function(const char *p_name, int64_t p_hash);

} // namespace internal

inline Variant &Array::operator[](int64_t p_index) {
	return *static_cast<Variant *>(internal::engine.array_operator_index(opaque, p_index));
}

inline const Variant &Array::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(internal::engine.array_operator_index_const(opaque, p_index));
}

inline Variant &Dictionary::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(internal::engine.dictionary_operator_index(opaque, p_key.opaque));
}

inline const Variant &Dictionary::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(internal::engine.dictionary_operator_index_const(opaque, p_key.opaque));
}

inline String operator+(const char *p_left, const String &p_right) {
	return String(p_left) + p_right;
}

inline String operator+(const String &p_left, const char *p_right) {
	return p_left + String(p_right);
}

template <class T>
TypedArray<T>::TypedArray() {
	const Variant no_script;
	const StringName no_class;
	if constexpr (is_builtin_v<T>) {
		internal::engine.array_set_typed(opaque, BuiltinType<T>::value, no_class.opaque, no_script.opaque);
	} else if constexpr (std::is_arithmetic_v<T>) {
		const auto type = static_cast<GDExtensionVariantType>(Variant(T()).get_type());
		internal::engine.array_set_typed(opaque, type, no_class.opaque, no_script.opaque);
	} else {
		internal::engine.array_set_typed(
				opaque, GDEXTENSION_VARIANT_TYPE_OBJECT, T::get_class_static().opaque, no_script.opaque);
	}
}

template <class T>
TypedArray<T>::TypedArray(const Array &p_array) : TypedArray() {
	if (is_same_typed(p_array)) {
		Array::operator=(p_array);
	} else {
		assign(p_array);
	}
}

} // namespace godot
