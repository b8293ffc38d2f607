// SPDX-License-Identifier: MIT
#pragma once

#include <mvn/datagram.hpp>

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <vector>

namespace godot {

/// Takes a dictionary apart, and notes the first thing that is wrong.
class DictionaryReader {
public:
	explicit DictionaryReader(const Dictionary &p_source) : _source(p_source) {}

	const String &fault() const { return _fault; }

	/// A value of a type, or false if it is missing or of another.
	bool find(const char *p_key, Variant::Type p_type, bool p_is_needed, Variant &r_value) {
		if (!_source.has(p_key)) {
			if (p_is_needed) {
				fail(String("there is no \"") + p_key + "\"");
			}
			return false;
		}
		r_value = _source.get(p_key, Variant());
		if (r_value.get_type() != p_type) {
			fail(String("\"") + p_key + "\" is no " + Variant::get_type_name(p_type));
			return false;
		}
		return true;
	}

	int64_t number(const char *p_key, bool p_is_needed, int64_t p_most) {
		Variant value;
		if (!find(p_key, Variant::INT, p_is_needed, value)) {
			return 0;
		}
		const int64_t found = value;
		if (found < 0 || found > p_most) {
			fail(String("\"") + p_key + "\" is too large or negative");
			return 0;
		}
		return found;
	}

	/// The ids decide how many items there are.
	template <class Item, class Number>
	void ids(const char *p_key, std::vector<Item> &r_items, Number Item::*p_field, bool p_decides) {
		Variant value;
		if (!find(p_key, Variant::PACKED_INT32_ARRAY, true, value)) {
			return;
		}
		const PackedInt32Array column = value;
		if (p_decides) {
			r_items.resize(std::size_t(column.size()));
		} else if (!fits(p_key, column.size(), r_items.size())) {
			return;
		}
		for (std::size_t at = 0; at < r_items.size(); ++at) {
			r_items[at].*p_field = Number(column[int64_t(at)]);
		}
	}

	template <class Item>
	bool vectors(const char *p_key, std::vector<Item> &r_items, mvn::Vector Item::*p_field, bool p_is_needed = true) {
		Variant value;
		if (!find(p_key, Variant::PACKED_VECTOR3_ARRAY, p_is_needed, value)) {
			return false;
		}
		const PackedVector3Array column = value;
		if (column.size() == 0 && !p_is_needed) {
			return false;
		}
		if (!fits(p_key, column.size(), r_items.size())) {
			return false;
		}
		for (std::size_t at = 0; at < r_items.size(); ++at) {
			const Vector3 &one = column[int64_t(at)];
			r_items[at].*p_field = { float(one.x), float(one.y), float(one.z) };
		}
		return true;
	}

	template <class Item>
	void names(const char *p_key, std::vector<Item> &r_items) {
		Variant value;
		if (!find(p_key, Variant::PACKED_STRING_ARRAY, true, value)) {
			return;
		}
		const PackedStringArray column = value;
		if (fits(p_key, column.size(), r_items.size())) {
			for (std::size_t at = 0; at < r_items.size(); ++at) {
				r_items[at].name = column[int64_t(at)].utf8().get_data();
			}
		}
	}

	template <class Item>
	void rotations(std::vector<Item> &r_items) {
		Variant value;
		if (!find("orientations", Variant::PACKED_FLOAT32_ARRAY, true, value)) {
			return;
		}
		const PackedFloat32Array column = value;
		if (!fits("orientations", column.size(), r_items.size() * 4)) {
			return;
		}
		PackedByteArray present;
		if (find("present", Variant::PACKED_BYTE_ARRAY, false, value)) {
			present = value;
		}
		for (std::size_t at = 0; at < r_items.size(); ++at) {
			for (std::size_t part = 0; part < 4; ++part) {
				r_items[at].rotation[part] = column[int64_t(at * 4 + part)];
			}
			r_items[at].has_rotation = int64_t(at) >= present.size() || present[int64_t(at)] != 0;
		}
	}

	void fail(const String &p_why) {
		if (_fault.is_empty()) {
			_fault = p_why;
		}
	}

private:
	bool fits(const char *p_key, int64_t p_size, std::size_t p_expected) {
		if (p_size != int64_t(p_expected)) {
			fail(String("\"") + p_key + "\" has another number of entries than there are items");
			return false;
		}
		return true;
	}

	const Dictionary &_source;
	String _fault;
};

} // namespace godot
