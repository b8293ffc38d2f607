// SPDX-License-Identifier: MIT
#pragma once

#include <head.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// A measured head. Documented in doc_classes/BinauralHead.xml.
class BinauralHead : public RefCounted {
	GDCLASS(BinauralHead, RefCounted)

public:
	String open(const PackedByteArray &p_bytes, double p_rate);
	bool is_open() const { return _head.is_open(); }

	const audio::Head &head() const { return _head; }

protected:
	static void _bind_methods();

private:
	audio::Head _head;
};

} // namespace godot
