#pragma once
// Variant and every builtin type. One header on purpose: the types refer to one another.
#include <godot_cpp/core/gdi.gen.hpp>
#include <godot_cpp/classes/global_constants.hpp>
#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

namespace godot {
class Object;
class Variant;
template <class T> class Ref;
template <class T> class BitField {
	int64_t v;
public:
	BitField(T e) : v(int64_t(e)) {}
	BitField(int64_t i = 0) : v(i) {}
	operator int64_t() const { return v; }
};

namespace internal { // Declared early for the vararg methods of builtin types.
GDExtensionPtrBuiltInMethod builtin_method(GDExtensionVariantType t, const char *name, int64_t hash);
template <class R, class... A> R call_builtin(GDExtensionPtrBuiltInMethod fn, void *base, const A &...a);
template <class T> Variant variant(const T &v);
template <class T, class...> struct DepT { using type = T; };
template <class T, class... A> using Dep = typename DepT<T, A...>::type;
}
#define MINI_VEC_OPS(V, S, N)                                                                                                \
	S &operator[](int i) { return (&x)[i]; }                                                                                 \
	const S &operator[](int i) const { return (&x)[i]; }                                                                     \
	V operator+(const V &o) const { V r; for (int i = 0; i < N; i++) r[i] = (*this)[i] + o[i]; return r; }                   \
	V operator-(const V &o) const { V r; for (int i = 0; i < N; i++) r[i] = (*this)[i] - o[i]; return r; }                   \
	V operator*(const V &o) const { V r; for (int i = 0; i < N; i++) r[i] = (*this)[i] * o[i]; return r; }                   \
	V operator*(S s) const { V r; for (int i = 0; i < N; i++) r[i] = (*this)[i] * s; return r; }                             \
	V operator/(S s) const { V r; for (int i = 0; i < N; i++) r[i] = (*this)[i] / s; return r; }                             \
	V operator-() const { V r; for (int i = 0; i < N; i++) r[i] = -(*this)[i]; return r; }                                   \
	V &operator+=(const V &o) { return *this = *this + o; }                                                                  \
	V &operator-=(const V &o) { return *this = *this - o; }                                                                  \
	bool operator==(const V &o) const { for (int i = 0; i < N; i++) if ((*this)[i] != o[i]) return false; return true; }     \
	bool operator!=(const V &o) const { return !(*this == o); }

#include <godot_cpp/variant/builtins.gen.inc>

class Variant {
public:
	alignas(8) uint8_t opaque[24] = {};
#include <godot_cpp/variant/variant_enums.inc>
	Variant() = default; // All zero bytes is NIL.
	Variant(const Variant &o) { gdi::f.variant_new_copy(opaque, o.opaque); }
	Variant(Variant &&o) noexcept { std::swap(opaque, o.opaque); }
	~Variant() { gdi::f.variant_destroy(opaque); }
	Variant &operator=(const Variant &o) { if (this != &o) { gdi::f.variant_destroy(opaque); gdi::f.variant_new_copy(opaque, o.opaque); } return *this; }
	Variant &operator=(Variant &&o) noexcept { std::swap(opaque, o.opaque); return *this; }
	Variant(bool v);
	template <class T, std::enable_if_t<(std::is_integral_v<T> || std::is_enum_v<T>) && !std::is_same_v<T, bool>, int> = 0>
	Variant(T v) { from_int(int64_t(v)); }
	Variant(double v);
	Variant(float v) : Variant(double(v)) {}
	Variant(const char *s) : Variant(String(s)) {}
	Variant(const Object *o);
	template <class T> Variant(const Ref<T> &r) : Variant(static_cast<const Object *>(r.ptr())) {}
#include <godot_cpp/variant/variant_conv.gen.inc>
	operator bool() const;
	operator int64_t() const;
	operator int32_t() const { return int32_t(int64_t(*this)); }
	operator double() const;
	operator float() const { return float(double(*this)); }
	operator Object *() const;
	Type get_type() const { return Type(gdi::f.variant_get_type(opaque)); }
	bool operator==(const Variant &o) const;
	bool operator!=(const Variant &o) const { return !(*this == o); }
	String stringify() const;
private:
	void from_int(int64_t v);
};

template <class T> struct BuiltinType { static constexpr auto value = GDEXTENSION_VARIANT_TYPE_NIL; };
#include <godot_cpp/variant/builtin_types.gen.inc>
template <class T> constexpr bool is_builtin_v = BuiltinType<T>::value != GDEXTENSION_VARIANT_TYPE_NIL;

namespace internal {
template <class T> Variant variant(const T &v) { return Variant(v); }
template <class T> void destroy(T &t) { t.~T(); }

// How a C++ value is laid out for a ptrcall argument: ints as int64, floats as double, objects as a pointer, builtins in place.
template <class T> struct PtrArg {
	using D = std::decay_t<T>;
	static constexpr bool in_place = is_builtin_v<D> || std::is_same_v<D, Variant>;
	using Store = std::conditional_t<std::is_same_v<D, bool>, uint8_t, std::conditional_t<std::is_floating_point_v<D>, double, int64_t>>;
	Store s{};
	const void *p;
	PtrArg(const T &v) {
		if constexpr (in_place) {
			p = &v;
		} else if constexpr (std::is_convertible_v<D, const Object *> || std::is_pointer_v<D>) {
			p = object_arg(v, s);
		} else if constexpr (requires_ptr<D>::value) {
			p = object_arg(v.ptr(), s);
		} else {
			s = Store(v);
			p = &s;
		}
	}
	template <class U, class = void> struct requires_ptr : std::false_type {};
	template <class U> struct requires_ptr<U, std::void_t<decltype(std::declval<const U &>().ptr())>> : std::true_type {};
	template <class O> static const void *object_arg(O *o, int64_t &s) { // O is complete wherever this is instantiated.
		s = o ? int64_t(o->_owner) : 0;
		return &s;
	}
};

template <class F, class... A> void construct(F fn, void *base, const A &...a) {
	if constexpr (sizeof...(A) == 0) {
		fn(base, nullptr);
	} else {
		auto go = [&](const auto &...pa) { const void *args[] = { pa.p... }; fn(base, args); };
		go(PtrArg<A>(a)...);
	}
}

template <class R> struct PtrRet { R v{}; void *p() { return &v; } R get() { return std::move(v); } };
template <> struct PtrRet<bool> { uint8_t v = 0; void *p() { return &v; } bool get() { return v != 0; } };
template <class R> struct NumRet { std::conditional_t<std::is_floating_point_v<R>, double, int64_t> v{}; void *p() { return &v; } R get() { return R(v); } };
template <class R> using RetStore = std::conditional_t<(std::is_arithmetic_v<R> || std::is_enum_v<R>) && !std::is_same_v<R, bool>, NumRet<R>, PtrRet<R>>;

template <class R, class... A> R call_builtin(GDExtensionPtrBuiltInMethod fn, void *base, const A &...a) {
	auto go = [&](const auto &...pa) -> R {
		const void *args[sizeof...(A) + 1] = { pa.p..., nullptr };
		if constexpr (std::is_void_v<R>) {
			fn(base, args, nullptr, sizeof...(A));
		} else {
			RetStore<R> r;
			fn(base, args, r.p(), sizeof...(A));
			return r.get();
		}
	};
	return go(PtrArg<A>(a)...);
}
template <class R, class L, class O> R call_operator(GDExtensionPtrOperatorEvaluator fn, const L *l, const O &o) {
	RetStore<R> r;
	PtrArg<O> pa(o);
	fn(l, pa.p, r.p());
	return r.get();
}
template <class R, class... A> R call_utility(GDExtensionPtrUtilityFunction fn, const A &...a) {
	auto go = [&](const auto &...pa) -> R {
		const void *args[sizeof...(A) + 1] = { pa.p..., nullptr };
		if constexpr (std::is_void_v<R>) {
			fn(nullptr, args, sizeof...(A));
		} else {
			RetStore<R> r;
			fn(r.p(), args, sizeof...(A));
			return r.get();
		}
	};
	return go(PtrArg<A>(a)...);
}
inline GDExtensionPtrBuiltInMethod builtin_method(GDExtensionVariantType t, const char *name, int64_t hash) { StringName n(name); return gdi::f.variant_get_ptr_builtin_method(t, n.opaque, hash); }
inline GDExtensionPtrUtilityFunction utility(const char *name, int64_t hash) { StringName n(name); return gdi::f.variant_get_ptr_utility_function(n.opaque, hash); }
} // namespace internal

inline Variant &Array::operator[](int64_t i) const { return *(Variant *)gdi::f.array_operator_index((void *)opaque, i); }
inline Variant &Dictionary::operator[](const Variant &k) const { return *(Variant *)gdi::f.dictionary_operator_index((void *)opaque, k.opaque); }
inline String operator+(const char *a, const String &b) { return String(a) + b; }
inline String operator+(const String &a, const char *b) { return a + String(b); }
template <class T> class TypedArray : public Array { public: using Array::Array; TypedArray()=default; TypedArray(const Array &a):Array(a){} TypedArray(const Variant &v):Array(v.operator Array()){} };
template <class T> struct BuiltinType<TypedArray<T>> { static constexpr auto value = GDEXTENSION_VARIANT_TYPE_ARRAY; };
} // namespace godot
