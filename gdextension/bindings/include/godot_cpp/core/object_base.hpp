#pragma once
#include <godot_cpp/variant/variant.hpp>
#include <cstdio>
#include <functional>
#include <vector>

namespace godot {
namespace gdi { extern GDExtensionClassLibraryPtr library; extern void *token; }

// The C++ half of an engine object: it holds the engine's pointer and nothing else.
class Wrapped {
public:
	GDExtensionObjectPtr _owner = nullptr;
	virtual ~Wrapped() = default;
	virtual const StringName *_extension_class() const { return nullptr; }
	virtual const GDExtensionInstanceBindingCallbacks *_callbacks() const { return nullptr; }
	void _notificationv(int32_t, bool) {}
	void _attach(); // Ties this C++ object to the engine object it constructed.
protected:
	explicit Wrapped(const StringName &engine_class) : _owner(gdi::f.classdb_construct_object2(engine_class.opaque)) {}
	explicit Wrapped(GDExtensionObjectPtr o) : _owner(o) {}
	template <class T, class B> static void register_virtuals() {}
};

namespace internal {
const StringName &forever(const char *s); // An interned name that is never freed (it must outlive static destructors).
void add_engine_class(const char *name, const GDExtensionInstanceBindingCallbacks *cb);
Wrapped *wrap_any(GDExtensionObjectPtr o, const GDExtensionInstanceBindingCallbacks *fallback);
template <class T> T *wrap(GDExtensionObjectPtr o) { return o ? static_cast<T *>(wrap_any(o, T::callbacks())) : nullptr; }
GDExtensionMethodBindPtr method_bind(const char *cls, const char *name, int64_t hash);
void varcall(GDExtensionMethodBindPtr mb, GDExtensionObjectPtr o, const Variant **args, int64_t n, Variant &ret);
inline Variant varcall(GDExtensionMethodBindPtr mb, GDExtensionObjectPtr o, const Variant **args, int64_t n) { Variant r; varcall(mb, o, args, n, r); return r; }
template <class T> struct EngineClass { EngineClass() { add_engine_class(T::class_name_cstr(), T::callbacks()); } };
template <class T> T *singleton(const char *name) { return wrap<T>(gdi::f.global_get_singleton(forever(name).opaque)); }
void post_new(Wrapped *w);
template <class T> T *post(T *t) { if constexpr (std::is_base_of_v<Wrapped, T>) post_new(t); return t; }
template <class T> struct RefOf { static constexpr bool value = false; };
template <class T> struct RefOf<Ref<T>> { static constexpr bool value = true; using type = T; };

template <class R, class... A> R ptrcall(GDExtensionMethodBindPtr mb, GDExtensionObjectPtr o, const A &...a) {
	auto go = [&](const auto &...pa) -> R {
		const void *args[sizeof...(A) + 1] = { pa.p..., nullptr };
		if constexpr (std::is_void_v<R>) {
			gdi::f.object_method_bind_ptrcall(mb, o, args, nullptr);
		} else if constexpr (std::is_pointer_v<R>) {
			GDExtensionObjectPtr r = nullptr;
			gdi::f.object_method_bind_ptrcall(mb, o, args, &r);
			return wrap<std::remove_pointer_t<R>>(r);
		} else if constexpr (RefOf<R>::value) {
			GDExtensionObjectPtr r = nullptr; // The engine hands over one reference.
			gdi::f.object_method_bind_ptrcall(mb, o, args, &r);
			return R::adopt(wrap<typename RefOf<R>::type>(r));
		} else {
			RetStore<R> r;
			gdi::f.object_method_bind_ptrcall(mb, o, args, r.p());
			return r.get();
		}
	};
	return go(PtrArg<A>(a)...);
}

// What the engine needs to know of a C++ type in a bound signature, and the conversions in both call styles.
template <class T, class = void> struct Traits;
template <class T> struct Traits<T, std::enable_if_t<is_builtin_v<T>>> {
	static constexpr auto type = BuiltinType<T>::value;
	static StringName class_name() { return StringName(); }
	static const T &from_ptr(const void *p) { return *(const T *)p; }
	static void to_ptr(const T &v, void *p) { *(T *)p = v; }
	static T from_variant(const Variant &v) { return v; }
};
template <> struct Traits<Variant> {
	static constexpr auto type = GDEXTENSION_VARIANT_TYPE_NIL;
	static StringName class_name() { return StringName(); }
	static const Variant &from_ptr(const void *p) { return *(const Variant *)p; }
	static void to_ptr(const Variant &v, void *p) { *(Variant *)p = v; }
	static const Variant &from_variant(const Variant &v) { return v; }
};
template <class T> struct Traits<T, std::enable_if_t<std::is_arithmetic_v<T> || std::is_enum_v<T>>> {
	using W = std::conditional_t<std::is_same_v<T, bool>, uint8_t, std::conditional_t<std::is_floating_point_v<T>, double, int64_t>>;
	static constexpr auto type = std::is_same_v<T, bool> ? GDEXTENSION_VARIANT_TYPE_BOOL : std::is_floating_point_v<T> ? GDEXTENSION_VARIANT_TYPE_FLOAT : GDEXTENSION_VARIANT_TYPE_INT;
	static StringName class_name() { return StringName(); }
	static T from_ptr(const void *p) { return T(*(const W *)p); }
	static void to_ptr(T v, void *p) { *(W *)p = W(v); }
	static T from_variant(const Variant &v) {
		if constexpr (std::is_same_v<T, bool>) return bool(v);
		else if constexpr (std::is_floating_point_v<T>) return T(double(v));
		else return T(int64_t(v));
	}
};
template <class T> struct Traits<T *, std::enable_if_t<std::is_base_of_v<Wrapped, T>>> {
	static constexpr auto type = GDEXTENSION_VARIANT_TYPE_OBJECT;
	static StringName class_name() { return T::get_class_static(); }
	static T *from_ptr(const void *p) { return wrap<T>(*(GDExtensionObjectPtr const *)p); }
	static void to_ptr(T *v, void *p) { *(GDExtensionObjectPtr *)p = v ? v->_owner : nullptr; }
	static T *from_variant(const Variant &v) { return dynamic_cast<T *>((Wrapped *)(Object *)v); }
};
template <class T> struct Traits<Ref<T>> {
	static constexpr auto type = GDEXTENSION_VARIANT_TYPE_OBJECT;
	static StringName class_name() { return T::get_class_static(); }
	static Ref<T> from_ptr(const void *p) { return Ref<T>(p ? wrap<T>(gdi::f.ref_get_object((GDExtensionConstRefPtr)p)) : nullptr); }
	static void to_ptr(const Ref<T> &v, void *p) { gdi::f.ref_set_object(p, v.is_valid() ? v->_owner : nullptr); }
	static Ref<T> from_variant(const Variant &v) { return Ref<T>(dynamic_cast<T *>((Wrapped *)(Object *)v)); }
};

struct VirtualCall { virtual ~VirtualCall() = default; virtual void call(Wrapped *self, const void *const *args, void *ret) = 0; };
void add_virtual(const StringName &cls, const char *name, VirtualCall *c);
template <class M> struct Sig;
template <class C, class R, class... P> struct Sig<R (C::*)(P...)> { using Ret = R; using Class = C; using Args = std::tuple<std::decay_t<P>...>; static constexpr bool is_const = false, is_static = false; };
template <class C, class R, class... P> struct Sig<R (C::*)(P...) const> { using Ret = R; using Class = C; using Args = std::tuple<std::decay_t<P>...>; static constexpr bool is_const = true, is_static = false; };
template <class R, class... P> struct Sig<R (*)(P...)> { using Ret = R; using Class = void; using Args = std::tuple<std::decay_t<P>...>; static constexpr bool is_const = false, is_static = true; };

template <class T, class M, size_t... I> decltype(auto) invoke_ptr(M m, T *self, const void *const *args, std::index_sequence<I...>) {
	using S = Sig<M>;
	if constexpr (S::is_static) return m(Traits<std::tuple_element_t<I, typename S::Args>>::from_ptr(args[I])...);
	else return (self->*m)(Traits<std::tuple_element_t<I, typename S::Args>>::from_ptr(args[I])...);
}
template <class T, class M> void ptr_entry(M m, void *self, const void *const *args, void *ret) {
	using S = Sig<M>;
	constexpr auto seq = std::make_index_sequence<std::tuple_size_v<typename S::Args>>();
	T *t = static_cast<T *>((Wrapped *)self);
	if constexpr (std::is_void_v<typename S::Ret>) invoke_ptr<T>(m, t, args, seq);
	else Traits<std::decay_t<typename S::Ret>>::to_ptr(invoke_ptr<T>(m, t, args, seq), ret);
}
template <class T, class M> void bind_virtual(const char *name, M m) {
	struct V : VirtualCall { M m; V(M m) : m(m) {} void call(Wrapped *s, const void *const *a, void *r) override { ptr_entry<T>(m, s, a, r); } };
	add_virtual(T::get_class_static(), name, new V(m));
}
} // namespace internal

#define memnew(m_class) (::godot::internal::post(new m_class))
template <class T> void memdelete(T *t) {
	if constexpr (std::is_base_of_v<Wrapped, T>) gdi::f.object_destroy(t->_owner);
	else delete t;
}

#define GDENGINE_CLASS(C, B)                                                                                                                      \
public:                                                                                                                                           \
	static const char *class_name_cstr() { return #C; }                                                                                           \
	static const ::godot::StringName &get_class_static() { static const ::godot::StringName &n = ::godot::internal::forever(#C); return n; }      \
	static const GDExtensionInstanceBindingCallbacks *callbacks() {                                                                               \
		static const GDExtensionInstanceBindingCallbacks cb = {                                                                                   \
			[](void *, void *o) -> void * { return static_cast<::godot::Wrapped *>(new C(o)); },                                                  \
			[](void *, void *, void *b) { delete static_cast<::godot::Wrapped *>(b); },                                                           \
			[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },                                                              \
		};                                                                                                                                        \
		return &cb;                                                                                                                               \
	}                                                                                                                                             \
	const GDExtensionInstanceBindingCallbacks *_callbacks() const override { return callbacks(); }                                                \
	C() : C(get_class_static()) {}                                                                                                                \
	explicit C(GDExtensionObjectPtr o) : B(o) {}                                                                                                  \
	static auto _get_notification() { return (void (::godot::Wrapped::*)(int)) & C::_notification; }   \
	static void initialize_class() {}                                                                                                             \
	static void _bind_methods() {}                                                                                                                \
protected:                                                                                                                                        \
	explicit C(const ::godot::StringName &n) : B(n) {}                                                                                            \
	void _notification(int) {}

#define ERR_FAIL_NULL(p) do { if (!(p)) { ::godot::internal::error("\"" #p "\" is null.", __func__, __FILE__, __LINE__); return; } } while (0)
#define ERR_FAIL_COND(c) do { if (c) { ::godot::internal::error("Condition \"" #c "\" is true.", __func__, __FILE__, __LINE__); return; } } while (0)
#define ERR_CONTINUE(c) if (c) { ::godot::internal::error("Condition \"" #c "\" is true. Continuing.", __func__, __FILE__, __LINE__); continue; } else ((void)0)
namespace internal { inline void error(const char *m, const char *fn, const char *file, int line) { gdi::f.print_error(m, fn, file, line, false); } }
} // namespace godot
#define ERR_FAIL_COND_V_MSG(c, r, m) do { if (c) { ::godot::internal::error(m, __func__, __FILE__, __LINE__); return r; } } while (0)
#define ERR_FAIL_NULL_V_MSG(p, r, m) do { if (!(p)) { ::godot::internal::error(m, __func__, __FILE__, __LINE__); return r; } } while (0)
