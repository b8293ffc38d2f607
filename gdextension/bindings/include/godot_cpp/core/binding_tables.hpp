// SPDX-License-Identifier: MIT
#pragma once

// What the generated sources hold of the engine: pointers to its functions, looked up all at once
// at start-up, so that a call costs no more than the call, and so that a missing function is an
// error message at start-up instead of a crash later.

#include <godot_cpp/core/engine_interface.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace godot {

class Variant;

namespace internal {

/// A stretch of elements that somebody else owns.
template <class T>
struct Span {
	T *elements = nullptr;
	std::size_t size = 0;

	T *begin() const { return elements; }
	T *end() const { return elements + size; }
};

template <class T, std::size_t N>
constexpr Span<T> span(T (&p_elements)[N]) {
	return { p_elements, N };
}

/// A method of an engine class.
struct MethodBind {
	const char *name;
	GDExtensionInt hash;
	GDExtensionMethodBindPtr bind = nullptr;

	void ptrcall(GDExtensionObjectPtr p_object, const void *const *p_arguments, void *r_result) const {
		engine.object_method_bind_ptrcall(bind, p_object, p_arguments, r_result);
	}
	/// For methods that take any number of arguments, each a Variant.
	Variant call(GDExtensionObjectPtr p_object, const void *const *p_arguments, int64_t p_count) const;
};

/// A method of a builtin type.
struct BuiltinMethod {
	const char *name;
	GDExtensionInt hash;
	GDExtensionPtrBuiltInMethod function = nullptr;
};

struct BuiltinConstructor {
	int32_t index;
	GDExtensionPtrConstructor function = nullptr;
};

struct BuiltinOperator {
	GDExtensionVariantOperator name;
	GDExtensionVariantType right;
	GDExtensionPtrOperatorEvaluator function = nullptr;
};

struct UtilityFunction {
	const char *name;
	GDExtensionInt hash;
	GDExtensionPtrUtilityFunction function = nullptr;
};

/// Everything of one builtin type.
struct BuiltinTable {
	GDExtensionVariantType type;
	const char *name;
	Span<BuiltinConstructor> constructors;
	Span<BuiltinMethod> methods;
	Span<BuiltinOperator> operators;
	GDExtensionPtrDestructor *destructor;
};

/// Everything of one engine class.
struct EngineClass {
	const char *name;
	const GDExtensionInstanceBindingCallbacks *callbacks;
	Span<MethodBind> methods;
};

// Made by the generator.
const std::vector<const BuiltinTable *> &builtin_tables();
const std::vector<EngineClass *> &engine_classes();
Span<UtilityFunction> utility_functions();
extern MethodBind object_is_class;

} // namespace internal

} // namespace godot
