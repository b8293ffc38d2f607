// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace probe {

/// Works with bodies through the physics server, as a motor does.
class BodyProbe : public godot::Node {
	GDCLASS(BodyProbe, godot::Node)

public:
	void _physics_process(double p_delta) override;
	void set_bodies(const godot::TypedArray<godot::RID> &p_bodies);
	int get_ticks() const { return _ticks; }
	double get_height() const { return _height; }
	/// A joint between two bodies, with a motor.
	godot::RID join(const godot::RID &p_body_a, const godot::RID &p_body_b) const;
	/// Nanoseconds for a state, a transform and a velocity of one body: the best of several runs.
	double time_state_ns(int p_rounds) const;

protected:
	static void _bind_methods();

private:
	std::vector<godot::RID> _bodies;
	int _ticks = 0;
	double _height = 0.0;
};

} // namespace probe
