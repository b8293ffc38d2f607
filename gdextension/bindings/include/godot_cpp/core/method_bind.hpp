// SPDX-License-Identifier: MIT
#pragma once

// Methods of extension classes as scripts call them.
#include <godot_cpp/core/property_info.hpp>

#include <memory>

namespace godot {

/// The name of a method and of its arguments.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> arguments;
};

template <class... Names>
MethodDefinition D_METHOD(const char *p_name, Names... p_arguments) {
	return { StringName(p_name), { StringName(p_arguments)... } };
}

#define DEFVAL(m_value) (m_value)

namespace internal {

/// A bound method of an extension class.
class MethodBind {
public:
	virtual ~MethodBind() = default;
	virtual void call_ptr(void *p_self, const void *const *p_arguments, void *r_result) const = 0;
	virtual void call_variant(void *p_self, const Variant *const *p_arguments, Variant &r_result) const = 0;

	MethodDefinition definition;
	std::vector<Variant> defaults; // Of the last arguments.
	PropertyInfo result;
	std::vector<PropertyInfo> arguments;
	bool has_result = false;
	bool is_const = false;
	bool is_static = false;
};

template <class T, class M>
class MethodBindOf : public MethodBind {
public:
	explicit MethodBindOf(M p_method) : method(p_method) {
		is_const = Signature<M>::is_const;
		is_static = Signature<M>::is_static;
		has_result = !std::is_void_v<Result>;
		if constexpr (!std::is_void_v<Result>) {
			result = describe_type<std::decay_t<Result>>();
		}
		describe_arguments(Indices<M>());
	}
	void call_ptr(void *p_self, const void *const *p_arguments, void *r_result) const override {
		ptr_entry<T>(method, p_self, p_arguments, r_result);
	}
	void call_variant(void *p_self, const Variant *const *p_arguments, Variant &r_result) const override {
		if constexpr (std::is_void_v<Result>) {
			invoke(p_self, p_arguments, Indices<M>());
		} else {
			r_result = Variant(invoke(p_self, p_arguments, Indices<M>()));
		}
	}

private:
	using Result = typename Signature<M>::Result;

	template <size_t... I>
	void describe_arguments(std::index_sequence<I...>) {
		arguments = { describe_type<std::tuple_element_t<I, typename Signature<M>::Arguments>>()... };
	}

	template <size_t... I>
	decltype(auto) invoke([[maybe_unused]] void *p_self, [[maybe_unused]] const Variant *const *p_arguments,
			std::index_sequence<I...>) const {
		if constexpr (Signature<M>::is_static) {
			return method(ArgumentTraits<M, I>::from_variant(*p_arguments[I])...);
		} else {
			T *self = static_cast<T *>(static_cast<Wrapped *>(p_self));
			return (self->*method)(ArgumentTraits<M, I>::from_variant(*p_arguments[I])...);
		}
	}

	M method;
};

void add_method(const StringName &p_class, std::unique_ptr<MethodBind> p_method);

} // namespace internal

} // namespace godot
