// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace probe {

/// Watches how the engine calls virtuals and sends notifications.
class NodeProbe : public godot::Node3D {
	GDCLASS(NodeProbe, godot::Node3D)

public:
	NodeProbe();
	void _enter_tree() override { _entered++; }
	void _ready() override { _readied++; }
	godot::PackedStringArray _get_configuration_warnings() const override;

	int get_entered() const { return _entered; }
	int get_readied() const { return _readied; }
	godot::PackedStringArray get_notified() const { return _notified; }
	godot::Node *get_built_in() const { return _built_in; }

	/// 0 nothing, 1 a node, 2 a Node3D, 3 a NodeProbe, 4 a LoudNodeProbe.
	int kind_of(godot::Node *p_node) const;
	bool is_self(godot::Object *p_object) const { return p_object == this; }
	godot::Object *child_as_object(int p_index) const { return get_child(p_index); }
	void spawn(int p_count);
	godot::TypedArray<godot::Node> list_children() const { return get_children(); }
	godot::Node *find(const godot::NodePath &p_path) const { return get_node<godot::Node>(p_path); }

protected:
	static void _bind_methods();
	void _notification(int p_what);

	godot::PackedStringArray _notified;

private:
	int _entered = 0;
	int _readied = 0;
	godot::Node *_built_in = nullptr;
};

/// Inherits from a class of the extension.
class LoudNodeProbe : public NodeProbe {
	GDCLASS(LoudNodeProbe, NodeProbe)

public:
	void _process(double p_delta) override;
	int get_frames() const { return _frames; }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	int _frames = 0;
};

/// Answers a virtual that has a result.
class ResourceProbe : public godot::Resource {
	GDCLASS(ResourceProbe, godot::Resource)

public:
	godot::RID _get_rid() const override;

protected:
	static void _bind_methods() {}
};

/// Can't be made by scripts.
class AbstractProbe : public godot::Node {
	GDCLASS(AbstractProbe, godot::Node)

public:
	virtual int answer() const = 0;

protected:
	static void _bind_methods();
};

/// Inherits from it.
class ConcreteProbe : public AbstractProbe {
	GDCLASS(ConcreteProbe, AbstractProbe)

public:
	int answer() const override { return 42; }

protected:
	static void _bind_methods() {}
};

} // namespace probe
