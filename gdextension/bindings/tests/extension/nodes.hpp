// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/templates/vector.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>

namespace bindings_test {

/// Objects in both directions, virtual methods and notifications.
class BindingsNode : public godot::Node3D {
	GDCLASS(BindingsNode, godot::Node3D)

public:
	godot::Object *child_object(int p_index) const { return get_child(p_index); }
	/// 0 for null, 1 for an engine class, 2 for this class, 3 for its heir.
	int kind(godot::Node *p_node) const;
	bool is_me(godot::Object *p_object) const { return p_object == this; }
	void spawn(int p_count);
	int64_t kinds_of_children() const;
	godot::Callable own_callable() { return godot::Callable(this, "get_enter_count"); }
	int get_enter_count() const { return enter_count; }
	int get_ready_count() const { return ready_count; }

	void _ready() override { ready_count++; }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	int enter_count = 0;
	int ready_count = 0;
};

/// Inherits from a class of the extension, and has no _notification of its own.
class BindingsNodeHeir : public BindingsNode {
	GDCLASS(BindingsNodeHeir, BindingsNode)

public:
	void _process(double p_delta) override;
	int get_frame_count() const { return frame_count; }

protected:
	static void _bind_methods();

private:
	int frame_count = 0;
};

/// Calls a singleton of the engine on each physics tick.
class BindingsDriver : public godot::Node {
	GDCLASS(BindingsDriver, godot::Node)

public:
	void _physics_process(double p_delta) override;
	void add_body(const godot::RID &p_body) { bodies.push_back(p_body); }
	godot::RID add_joint(const godot::RID &p_body_a, const godot::RID &p_body_b) const;
	int64_t get_tick_count() const { return tick_count; }
	double get_height() const { return height; }

protected:
	static void _bind_methods();

private:
	godot::Vector<godot::RID> bodies;
	int64_t tick_count = 0;
	double height = 0.0; // Of the first body, in metres.
};

} // namespace bindings_test
