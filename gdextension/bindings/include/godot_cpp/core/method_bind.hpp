// SPDX-License-Identifier: MIT
#pragma once

// Functions of an extension's classes as the engine calls them.

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/type_info.hpp>

#include <memory>
#include <tuple>
#include <vector>

namespace godot {

/// The name of a method and of its arguments: made by D_METHOD.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> arguments;

	MethodDefinition(const char *p_name) : name(p_name) {}
	template <class... Names>
	MethodDefinition(const char *p_name, const Names &...p_arguments) :
			name(p_name), arguments{ StringName(p_arguments)... } {}
};

namespace internal {

/// Takes the type of a function to pieces.
template <class Function>
struct Signature;

template <class C, class R, class... P>
struct Signature<R (C::*)(P...)> {
	using Class = C;
	using Result = std::decay_t<R>;
	using Arguments = std::tuple<std::decay_t<P>...>;
	static constexpr bool is_const = false;
	static constexpr bool is_static = false;
};

template <class C, class R, class... P>
struct Signature<R (C::*)(P...) const> : Signature<R (C::*)(P...)> {
	static constexpr bool is_const = true;
};

template <class R, class... P>
struct Signature<R (*)(P...)> {
	using Class = Wrapped;
	using Result = std::decay_t<R>;
	using Arguments = std::tuple<std::decay_t<P>...>;
	static constexpr bool is_const = false;
	static constexpr bool is_static = true;
};

/// A function and how to call it with arguments in either form.
template <class Function>
class Callee {
	using Parts = Signature<Function>;
	using Class = typename Parts::Class;
	using Result = typename Parts::Result;
	using Arguments = typename Parts::Arguments;
	template <std::size_t I>
	using Info = TypeInfo<std::tuple_element_t<I, Arguments>>;

public:
	static constexpr std::size_t argument_count = std::tuple_size_v<Arguments>;

	explicit Callee(Function p_function) : function(p_function) {}

	void call_with_pointers(Wrapped *p_self, const void *const *p_arguments, void *r_result) const {
		by_pointer(p_self, p_arguments, r_result, std::make_index_sequence<argument_count>());
	}
	void call_with_variants(Wrapped *p_self, const Variant *const *p_arguments, Variant &r_result) const {
		by_variant(p_self, p_arguments, r_result, std::make_index_sequence<argument_count>());
	}

private:
	template <class... Values>
	decltype(auto) invoke(Wrapped *p_self, Values &&...p_values) const {
		if constexpr (Parts::is_static) {
			return function(std::forward<Values>(p_values)...);
		} else {
			return (static_cast<Class *>(p_self)->*function)(std::forward<Values>(p_values)...);
		}
	}
	template <std::size_t... I>
	void by_pointer(Wrapped *p_self, [[maybe_unused]] const void *const *p_arguments, [[maybe_unused]] void *r_result,
			std::index_sequence<I...>) const {
		if constexpr (std::is_void_v<Result>) {
			invoke(p_self, Info<I>::from_pointer(p_arguments[I])...);
		} else {
			TypeInfo<Result>::to_pointer(invoke(p_self, Info<I>::from_pointer(p_arguments[I])...), r_result);
		}
	}
	template <std::size_t... I>
	void by_variant(Wrapped *p_self, [[maybe_unused]] const Variant *const *p_arguments,
			[[maybe_unused]] Variant &r_result, std::index_sequence<I...>) const {
		if constexpr (std::is_void_v<Result>) {
			invoke(p_self, Info<I>::from_variant(*p_arguments[I])...);
		} else {
			r_result = Variant(invoke(p_self, Info<I>::from_variant(*p_arguments[I])...));
		}
	}

	Function function;
};

/// A function that overrides a virtual of the engine.
class VirtualMethod {
public:
	virtual ~VirtualMethod() = default;
	virtual void call(Wrapped *p_self, const void *const *p_arguments, void *r_result) const = 0;
};

template <class Function>
class VirtualMethodOf : public VirtualMethod {
public:
	explicit VirtualMethodOf(Function p_function) : callee(p_function) {}
	void call(Wrapped *p_self, const void *const *p_arguments, void *r_result) const override {
		callee.call_with_pointers(p_self, p_arguments, r_result);
	}

private:
	Callee<Function> callee;
};

/// A function that scripts can call.
class BoundMethod {
public:
	MethodDefinition definition;
	std::vector<Variant> defaults; // Of the last arguments.
	std::vector<PropertyInfo> properties; // First the result's, then the arguments'.
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata; // Likewise.
	bool has_result = false;
	uint32_t flags = GDEXTENSION_METHOD_FLAG_NORMAL;

	explicit BoundMethod(const MethodDefinition &p_definition) : definition(p_definition) {}
	virtual ~BoundMethod() = default;
	virtual void call_with_pointers(Wrapped *p_self, const void *const *p_arguments, void *r_result) const = 0;
	virtual void call_with_variants(Wrapped *p_self, const Variant *const *p_arguments, Variant &r_result) const = 0;

	int64_t argument_count() const { return int64_t(properties.size()) - 1; }
	/// Checks the arguments of a dynamic call, adds defaults, and calls.
	void call_checked(Wrapped *p_self, const GDExtensionConstVariantPtr *p_arguments, int64_t p_count,
			GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) const;
};

template <class Function>
class BoundMethodOf : public BoundMethod {
	using Parts = Signature<Function>;
	using Arguments = typename Parts::Arguments;

public:
	BoundMethodOf(const MethodDefinition &p_definition, Function p_function) :
			BoundMethod(p_definition), callee(p_function) {
		flags |= Parts::is_const ? GDEXTENSION_METHOD_FLAG_CONST : 0;
		flags |= Parts::is_static ? GDEXTENSION_METHOD_FLAG_STATIC : 0;
		has_result = !std::is_void_v<typename Parts::Result>;
		add_type<typename Parts::Result>();
		add_arguments(std::make_index_sequence<std::tuple_size_v<Arguments>>());
	}
	void call_with_pointers(Wrapped *p_self, const void *const *p_arguments, void *r_result) const override {
		callee.call_with_pointers(p_self, p_arguments, r_result);
	}
	void call_with_variants(Wrapped *p_self, const Variant *const *p_arguments, Variant &r_result) const override {
		callee.call_with_variants(p_self, p_arguments, r_result);
	}

private:
	template <class T>
	void add_type() {
		if constexpr (std::is_void_v<T>) {
			properties.push_back(PropertyInfo());
			metadata.push_back(GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE);
		} else {
			properties.push_back(TypeInfo<T>::property());
			metadata.push_back(TypeInfo<T>::metadata);
		}
	}
	template <std::size_t... I>
	void add_arguments(std::index_sequence<I...>) {
		(add_type<std::tuple_element_t<I, Arguments>>(), ...);
	}

	Callee<Function> callee;
};

} // namespace internal

} // namespace godot
