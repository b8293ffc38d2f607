// SPDX-License-Identifier: MIT
#include "probe.hpp"

using namespace godot;

namespace bindings_test {

int64_t BindingsProbe::alive = 0;

String BindingsProbe::greet(const String &p_name) const {
	return String("Hello, ") + p_name + "!";
}

PackedByteArray BindingsProbe::invert(const PackedByteArray &p_bytes) const {
	PackedByteArray result;
	const int64_t size = p_bytes.size();
	result.resize(size);
	const uint8_t *read = p_bytes.ptr();
	uint8_t *write = result.ptrw();
	for (int64_t i = 0; i < size; i++) {
		write[i] = static_cast<uint8_t>(255 - read[i]);
	}
	return result;
}

PackedFloat32Array BindingsProbe::prefix_sum(const PackedFloat32Array &p_numbers) const {
	PackedFloat32Array result;
	float sum = 0;
	for (int64_t i = 0; i < p_numbers.size(); i++) {
		sum += p_numbers[i];
		result.push_back(sum);
	}
	return result;
}

Array BindingsProbe::reversed(const Array &p_array) const {
	Array result;
	for (int64_t i = p_array.size() - 1; i >= 0; i--) {
		result.push_back(p_array[i]);
	}
	return result;
}

Dictionary BindingsProbe::describe(const Dictionary &p_dictionary) const {
	Dictionary result;
	result["count"] = p_dictionary.size();
	result["has_x"] = p_dictionary.has("x");
	if (p_dictionary.has("x")) {
		result["twice_x"] = double(p_dictionary["x"]) * 2.0;
	}
	result["keys"] = p_dictionary.keys();
	return result;
}

int64_t BindingsProbe::count_valid(const TypedArray<RID> &p_rids) const {
	int64_t count = 0;
	for (int64_t i = 0; i < p_rids.size(); i++) {
		const RID rid = p_rids[i];
		count += rid.is_valid() ? 1 : 0;
	}
	return count;
}

TypedArray<Vector3> BindingsProbe::corners() const {
	TypedArray<Vector3> result;
	result.push_back(Vector3());
	result.push_back(Vector3(1, 2, 3));
	return result;
}

bool BindingsProbe::guarded(bool p_fail) const {
	ERR_FAIL_COND_V_MSG(p_fail, false, "BindingsProbe: this error is expected.");
	return true;
}

Ref<BindingsProbe> BindingsProbe::make_child() const {
	Ref<BindingsProbe> child;
	child.instantiate();
	child->set_gain(gain * 2);
	return child;
}

Ref<BindingsProbe> BindingsProbe::hold(const Ref<BindingsProbe> &p_probe) {
	held = p_probe;
	return p_probe;
}

Array BindingsProbe::make_many(int p_count) const {
	Array result;
	for (int i = 0; i < p_count; i++) {
		Ref<BindingsProbe> probe;
		probe.instantiate();
		probe->set_gain(i);
		result.push_back(probe);
	}
	return result;
}

void BindingsProbe::set_gain(double p_gain) {
	gain = p_gain;
	emit_signal("gain_changed", p_gain, Vector3(1, 2, 3));
}

void BindingsProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("add", "a", "b"), &BindingsProbe::add);
	ClassDB::bind_method(D_METHOD("scale", "a", "b"), &BindingsProbe::scale, DEFVAL(3.0));
	ClassDB::bind_method(D_METHOD("flip", "value"), &BindingsProbe::flip);
	ClassDB::bind_method(D_METHOD("greet", "name"), &BindingsProbe::greet);
	ClassDB::bind_method(D_METHOD("utf8_length", "text"), &BindingsProbe::utf8_length);
	ClassDB::bind_method(D_METHOD("echo_name", "name"), &BindingsProbe::echo_name);
	ClassDB::bind_method(D_METHOD("echo", "value"), &BindingsProbe::echo);
	ClassDB::bind_method(D_METHOD("cross", "a", "b"), &BindingsProbe::cross);
	ClassDB::bind_method(D_METHOD("multiply", "a", "b"), &BindingsProbe::multiply);
	ClassDB::bind_method(D_METHOD("invert", "bytes"), &BindingsProbe::invert);
	ClassDB::bind_method(D_METHOD("prefix_sum", "numbers"), &BindingsProbe::prefix_sum);
	ClassDB::bind_method(D_METHOD("reversed", "array"), &BindingsProbe::reversed);
	ClassDB::bind_method(D_METHOD("describe", "dictionary"), &BindingsProbe::describe);
	ClassDB::bind_method(D_METHOD("count_valid", "rids"), &BindingsProbe::count_valid);
	ClassDB::bind_method(D_METHOD("corners"), &BindingsProbe::corners);
	ClassDB::bind_method(D_METHOD("guarded", "fail"), &BindingsProbe::guarded);
	ClassDB::bind_method(D_METHOD("make_child"), &BindingsProbe::make_child);
	ClassDB::bind_method(D_METHOD("hold", "probe"), &BindingsProbe::hold);
	ClassDB::bind_method(D_METHOD("release"), &BindingsProbe::release);
	ClassDB::bind_method(D_METHOD("make_many", "count"), &BindingsProbe::make_many);
	ClassDB::bind_method(D_METHOD("call_back", "callable"), &BindingsProbe::call_back);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &BindingsProbe::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &BindingsProbe::get_gain);
	ClassDB::bind_method(D_METHOD("set_mode", "mode"), &BindingsProbe::set_mode);
	ClassDB::bind_method(D_METHOD("get_mode"), &BindingsProbe::get_mode);
	ClassDB::bind_static_method("BindingsProbe", D_METHOD("alive_count"), &BindingsProbe::alive_count);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "gain"), "set_gain", "get_gain");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mode", PROPERTY_HINT_ENUM, "Idle:0,Run:5"), "set_mode", "get_mode");
	ADD_SIGNAL(
			MethodInfo("gain_changed", PropertyInfo(Variant::FLOAT, "gain"), PropertyInfo(Variant::VECTOR3, "vector")));
	BIND_ENUM_CONSTANT(MODE_IDLE);
	BIND_ENUM_CONSTANT(MODE_RUN);
}

} // namespace bindings_test
