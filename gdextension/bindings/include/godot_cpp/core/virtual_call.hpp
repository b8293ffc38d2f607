// SPDX-License-Identifier: MIT
#pragma once

// Methods of extension classes as the engine calls them by pointer.
#include <godot_cpp/core/type_traits.hpp>

namespace godot::internal {

/// Takes a pointer to a method or a static function apart.
template <class M>
struct Signature;

template <class C, class R, class... Parameters>
struct Signature<R (C::*)(Parameters...)> {
	using Class = C;
	using Result = R;
	using Arguments = std::tuple<std::decay_t<Parameters>...>;
	static constexpr bool is_const = false;
	static constexpr bool is_static = false;
};

template <class C, class R, class... Parameters>
struct Signature<R (C::*)(Parameters...) const> {
	using Class = C;
	using Result = R;
	using Arguments = std::tuple<std::decay_t<Parameters>...>;
	static constexpr bool is_const = true;
	static constexpr bool is_static = false;
};

template <class R, class... Parameters>
struct Signature<R (*)(Parameters...)> {
	using Class = void;
	using Result = R;
	using Arguments = std::tuple<std::decay_t<Parameters>...>;
	static constexpr bool is_const = false;
	static constexpr bool is_static = true;
};

template <class M>
using Indices = std::make_index_sequence<std::tuple_size_v<typename Signature<M>::Arguments>>;

template <class M, size_t I>
using ArgumentTraits = Traits<std::tuple_element_t<I, typename Signature<M>::Arguments>>;

template <class T, class M, size_t... I>
decltype(auto) invoke_ptr(M p_method, [[maybe_unused]] T *p_self, [[maybe_unused]] const void *const *p_arguments,
		std::index_sequence<I...>) {
	if constexpr (Signature<M>::is_static) {
		return p_method(ArgumentTraits<M, I>::from_ptr(p_arguments[I])...);
	} else {
		return (p_self->*p_method)(ArgumentTraits<M, I>::from_ptr(p_arguments[I])...);
	}
}

/// Calls a method of T with arguments by pointer.
template <class T, class M>
void ptr_entry(M p_method, void *p_self, const void *const *p_arguments, void *r_result) {
	using Result = typename Signature<M>::Result;
	T *self = static_cast<T *>(static_cast<Wrapped *>(p_self));
	if constexpr (std::is_void_v<Result>) {
		invoke_ptr<T>(p_method, self, p_arguments, Indices<M>());
	} else {
		Traits<std::decay_t<Result>>::to_ptr(invoke_ptr<T>(p_method, self, p_arguments, Indices<M>()), r_result);
	}
}

/// An overridden virtual method.
class VirtualCall {
public:
	virtual ~VirtualCall() = default;
	virtual void call(Wrapped *p_self, const void *const *p_arguments, void *r_result) = 0;
};

template <class T, class M>
class VirtualCallOf : public VirtualCall {
public:
	explicit VirtualCallOf(M p_method) : method(p_method) {}
	void call(Wrapped *p_self, const void *const *p_arguments, void *r_result) override {
		ptr_entry<T>(method, p_self, p_arguments, r_result);
	}

private:
	M method;
};

/// Takes the call over.
void add_virtual(const StringName &p_class, const char *p_name, VirtualCall *p_call);

template <class T, class M>
void bind_virtual(const char *p_name, M p_method) {
	add_virtual(T::get_class_static(), p_name, new VirtualCallOf<T, M>(p_method));
}

} // namespace godot::internal
