// SPDX-License-Identifier: MIT
#include "value_probe.hpp"

#include <godot_cpp/core/error_macros.hpp>

using namespace godot;

namespace probe {

int64_t ValueProbe::alive = 0;

String ValueProbe::greet(const String &p_name) const {
	return String("Hello, ") + p_name + "!";
}

Variant ValueProbe::call_back(const Callable &p_function) const {
	return p_function.call(3, "a");
}

PackedByteArray ValueProbe::invert(const PackedByteArray &p_bytes) const {
	PackedByteArray inverted;
	const int64_t size = p_bytes.size();
	inverted.resize(size);
	const uint8_t *read = p_bytes.ptr();
	uint8_t *write = inverted.ptrw();
	for (int64_t i = 0; i < size; i++) {
		write[i] = uint8_t(255 - read[i]);
	}
	return inverted;
}

PackedFloat32Array ValueProbe::prefix_sum(const PackedFloat32Array &p_values) const {
	PackedFloat32Array sums;
	float sum = 0.0f;
	for (int64_t i = 0; i < p_values.size(); i++) {
		sum += p_values[i];
		sums.push_back(sum);
	}
	return sums;
}

PackedVector3Array ValueProbe::literals() const {
	PackedVector3Array points = { Vector3(1, 2, 3), Vector3(4, 5, 6) };
	points[1] = points[1] * 2;
	Vector3 sum;
	for (const Vector3 &point : points) {
		sum += point;
	}
	points.push_back(sum);
	return points;
}

Array ValueProbe::reversed(const Array &p_array) const {
	Array result;
	for (int64_t i = p_array.size() - 1; i >= 0; i--) {
		result.push_back(p_array[i]);
	}
	return result;
}

Dictionary ValueProbe::describe(const Dictionary &p_dictionary) const {
	Dictionary result;
	result["count"] = p_dictionary.size();
	result["has_x"] = p_dictionary.has("x");
	if (p_dictionary.has("x")) {
		result["x2"] = double(p_dictionary["x"]) * 2.0;
	}
	result["keys"] = p_dictionary.keys();
	return result;
}

TypedArray<Vector3> ValueProbe::doubled(const TypedArray<Vector3> &p_vectors) const {
	TypedArray<Vector3> result;
	for (int64_t i = 0; i < p_vectors.size(); i++) {
		result.push_back(Vector3(p_vectors[i]) * 2);
	}
	return result;
}

TypedArray<Resource> ValueProbe::resources(int p_count) const {
	TypedArray<Resource> result;
	for (int i = 0; i < p_count; i++) {
		Ref<Resource> resource;
		resource.instantiate();
		resource->set_name(String::num_int64(i));
		result.push_back(resource);
	}
	return result;
}

String ValueProbe::formatted(const String &p_name, int p_number) const {
	return vformat("%s has %d", p_name, p_number);
}

Ref<ValueProbe> ValueProbe::make_child() const {
	Ref<ValueProbe> child;
	child.instantiate();
	child->set_gain(_gain * 2);
	return child;
}

Array ValueProbe::make_many(int p_count) const {
	Array many;
	for (int i = 0; i < p_count; i++) {
		Ref<ValueProbe> one = memnew(ValueProbe);
		one->set_gain(i);
		many.push_back(one);
	}
	return many;
}

Ref<ValueProbe> ValueProbe::hold(const Ref<ValueProbe> &p_probe) {
	_held = p_probe;
	return _held;
}

void ValueProbe::set_gain(double p_gain) {
	_gain = p_gain;
	emit_signal("gain_changed", p_gain, Vector3(1, 2, 3));
}

int ValueProbe::guarded(int p_index, const Object *p_object) const {
	ERR_FAIL_INDEX_V_MSG(p_index, 3, -1, vformat("There are three places, not %d.", p_index));
	ERR_FAIL_NULL_V_MSG(p_object, -2, "An object is needed.");
	ERR_FAIL_COND_V_MSG(p_index == 2, -3, "The third place is taken.");
	ERR_FAIL_COND_V(p_index == 1, -4);
	return p_index;
}

void ValueProbe::_bind_methods() {
	ClassDB::bind_static_method("ValueProbe", D_METHOD("get_alive"), &ValueProbe::get_alive);
	ClassDB::bind_method(D_METHOD("add", "left", "right"), &ValueProbe::add);
	ClassDB::bind_method(D_METHOD("add_small", "left", "right"), &ValueProbe::add_small, DEFVAL(7));
	ClassDB::bind_method(D_METHOD("scale", "value", "factor"), &ValueProbe::scale, DEFVAL(3.0));
	ClassDB::bind_method(D_METHOD("flip", "value"), &ValueProbe::flip);
	ClassDB::bind_method(D_METHOD("greet", "name"), &ValueProbe::greet);
	ClassDB::bind_method(D_METHOD("echo_name", "name"), &ValueProbe::echo_name);
	ClassDB::bind_method(D_METHOD("echo", "value"), &ValueProbe::echo);
	ClassDB::bind_method(D_METHOD("call_back", "function"), &ValueProbe::call_back);
	ClassDB::bind_method(D_METHOD("own_callable"), &ValueProbe::own_callable);
	ClassDB::bind_method(D_METHOD("invert", "bytes"), &ValueProbe::invert);
	ClassDB::bind_method(D_METHOD("prefix_sum", "values"), &ValueProbe::prefix_sum);
	ClassDB::bind_method(D_METHOD("literals"), &ValueProbe::literals);
	ClassDB::bind_method(D_METHOD("reversed", "array"), &ValueProbe::reversed);
	ClassDB::bind_method(D_METHOD("describe", "dictionary"), &ValueProbe::describe);
	ClassDB::bind_method(D_METHOD("doubled", "vectors"), &ValueProbe::doubled);
	ClassDB::bind_method(D_METHOD("resources", "count"), &ValueProbe::resources);
	ClassDB::bind_method(D_METHOD("formatted", "name", "number"), &ValueProbe::formatted);
	ClassDB::bind_method(D_METHOD("make_child"), &ValueProbe::make_child);
	ClassDB::bind_method(D_METHOD("make_many", "count"), &ValueProbe::make_many);
	ClassDB::bind_method(D_METHOD("hold", "probe"), &ValueProbe::hold);
	ClassDB::bind_method(D_METHOD("release"), &ValueProbe::release);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &ValueProbe::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &ValueProbe::get_gain);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &ValueProbe::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &ValueProbe::get_mode);
	ClassDB::bind_method(D_METHOD("set_flags", "flags"), &ValueProbe::set_flags);
	ClassDB::bind_method(D_METHOD("get_flags"), &ValueProbe::get_flags);
	ClassDB::bind_method(D_METHOD("guarded", "index", "object"), &ValueProbe::guarded);
	ADD_GROUP("Tuning", "");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,10,0.1,suffix:1/s"), "set_gain", "get_gain");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Idle:0,Run:5"), "set_mode", "get_mode");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "flags", PROPERTY_HINT_FLAGS, "A:1,B:4"), "set_flags", "get_flags");
	ADD_SIGNAL(
			MethodInfo("gain_changed", PropertyInfo(Variant::FLOAT, "gain"), PropertyInfo(Variant::VECTOR3, "extra")));
	BIND_ENUM_CONSTANT(MODE_IDLE);
	BIND_ENUM_CONSTANT(MODE_RUN);
	BIND_BITFIELD_FLAG(FLAG_A);
	BIND_BITFIELD_FLAG(FLAG_B);
}

} // namespace probe
