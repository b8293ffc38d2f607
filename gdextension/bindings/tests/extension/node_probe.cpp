// SPDX-License-Identifier: MIT
#include "node_probe.hpp"

#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

namespace probe {

NodeProbe::NodeProbe() {
	// The engine knows the object as a NodeProbe already.
	_built_in = memnew(Node3D);
	_built_in->set_name("BuiltIn");
	add_child(_built_in, false, INTERNAL_MODE_BACK);
}

PackedStringArray NodeProbe::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (get_child_count() == 0) {
		warnings.push_back("Add a child.");
	}
	return warnings;
}

int NodeProbe::kind_of(Node *p_node) const {
	if (Object::cast_to<LoudNodeProbe>(p_node) != nullptr) {
		return 4;
	}
	if (Object::cast_to<NodeProbe>(p_node) != nullptr) {
		return 3;
	}
	if (Object::cast_to<Node3D>(p_node) != nullptr) {
		return 2;
	}
	return p_node == nullptr ? 0 : 1;
}

void NodeProbe::spawn(int p_count) {
	for (int i = 0; i < p_count; i++) {
		switch (i % 4) {
			case 0:
				add_child(memnew(Node));
				break;
			case 1:
				add_child(memnew(Node3D));
				break;
			case 2:
				add_child(memnew(NodeProbe));
				break;
			default:
				add_child(memnew(LoudNodeProbe));
				break;
		}
	}
}

void NodeProbe::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		_notified.push_back("enter");
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		_notified.push_back("exit");
	}
}

void NodeProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_entered"), &NodeProbe::get_entered);
	ClassDB::bind_method(D_METHOD("get_readied"), &NodeProbe::get_readied);
	ClassDB::bind_method(D_METHOD("get_notified"), &NodeProbe::get_notified);
	ClassDB::bind_method(D_METHOD("get_built_in"), &NodeProbe::get_built_in);
	ClassDB::bind_method(D_METHOD("kind_of", "node"), &NodeProbe::kind_of);
	ClassDB::bind_method(D_METHOD("is_self", "object"), &NodeProbe::is_self);
	ClassDB::bind_method(D_METHOD("child_as_object", "index"), &NodeProbe::child_as_object);
	ClassDB::bind_method(D_METHOD("spawn", "count"), &NodeProbe::spawn);
	ClassDB::bind_method(D_METHOD("list_children"), &NodeProbe::list_children);
	ClassDB::bind_method(D_METHOD("find", "path"), &NodeProbe::find);
}

void LoudNodeProbe::_process(double) {
	_frames++;
}

void LoudNodeProbe::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		_notified.push_back("loud enter");
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		_notified.push_back("loud exit");
	}
}

void LoudNodeProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_frames"), &LoudNodeProbe::get_frames);
}

RID ResourceProbe::_get_rid() const {
	return UtilityFunctions::rid_from_int64(77);
}

void AbstractProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("answer"), &AbstractProbe::answer);
}

} // namespace probe
