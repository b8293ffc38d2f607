// SPDX-License-Identifier: MIT
#include "mvn_dictionary.hpp"

#include "mvn_dictionary_reader.hpp"

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <limits>

namespace godot {

namespace {

using mvn::Content;
using mvn::Type;

// Columns: one field of all items.

template <class Item>
PackedVector3Array vectors_of(const std::vector<Item> &p_items, mvn::Vector Item::*p_field) {
	PackedVector3Array column;
	column.resize(int64_t(p_items.size()));
	for (std::size_t at = 0; at < p_items.size(); ++at) {
		const mvn::Vector &value = p_items[at].*p_field;
		column[int64_t(at)] = Vector3(value[0], value[1], value[2]);
	}
	return column;
}

template <class Item, class Number>
PackedInt32Array numbers_of(const std::vector<Item> &p_items, Number Item::*p_field) {
	PackedInt32Array column;
	column.resize(int64_t(p_items.size()));
	for (std::size_t at = 0; at < p_items.size(); ++at) {
		column[int64_t(at)] = int32_t(p_items[at].*p_field);
	}
	return column;
}

template <class Item>
PackedStringArray names_of(const std::vector<Item> &p_items) {
	PackedStringArray column;
	column.resize(int64_t(p_items.size()));
	for (std::size_t at = 0; at < p_items.size(); ++at) {
		column[int64_t(at)] = String::utf8(p_items[at].name.c_str());
	}
	return column;
}

template <class Item>
void put_rotations(const std::vector<Item> &p_items, Dictionary &r_result) {
	PackedFloat32Array rotations;
	PackedByteArray present;
	rotations.resize(int64_t(p_items.size()) * 4);
	present.resize(int64_t(p_items.size()));
	for (std::size_t at = 0; at < p_items.size(); ++at) {
		present[int64_t(at)] = p_items[at].has_rotation ? 1 : 0;
		for (std::size_t part = 0; part < 4; ++part) {
			rotations[int64_t(at * 4 + part)] = p_items[at].rotation[part];
		}
	}
	r_result["orientations"] = rotations;
	r_result["present"] = present;
}

void put_motions(const Content &p_content, Dictionary &r_result) {
	const std::vector<mvn::SegmentMotion> &motions = p_content.motions;
	r_result["segments"] = numbers_of(motions, &mvn::SegmentMotion::id);
	if (p_content.header.type == Type::LINEAR_KINEMATICS) {
		r_result["positions"] = vectors_of(motions, &mvn::SegmentMotion::position);
		r_result["velocities"] = vectors_of(motions, &mvn::SegmentMotion::velocity);
		r_result["accelerations"] = vectors_of(motions, &mvn::SegmentMotion::acceleration);
		return;
	}
	put_rotations(motions, r_result);
	if (p_content.header.type == Type::ANGULAR_KINEMATICS) {
		r_result["angular_velocities"] = vectors_of(motions, &mvn::SegmentMotion::angular_velocity);
		r_result["angular_accelerations"] = vectors_of(motions, &mvn::SegmentMotion::angular_acceleration);
		return;
	}
	r_result["free_accelerations"] = vectors_of(motions, &mvn::SegmentMotion::free_acceleration);
	r_result["magnetic_fields"] = vectors_of(motions, &mvn::SegmentMotion::magnetic_field);
	const bool is_full = !motions.empty() && motions[0].is_full;
	r_result["accelerations"] = is_full ? vectors_of(motions, &mvn::SegmentMotion::acceleration) : PackedVector3Array();
	r_result["rates"] = is_full ? vectors_of(motions, &mvn::SegmentMotion::rate) : PackedVector3Array();
}

void put_scale(const Content &p_content, Dictionary &r_result) {
	r_result["names"] = names_of(p_content.origins);
	r_result["origins"] = vectors_of(p_content.origins, &mvn::SegmentOrigin::origin);
	r_result["point_segments"] = numbers_of(p_content.points, &mvn::BodyPoint::segment);
	r_result["point_numbers"] = numbers_of(p_content.points, &mvn::BodyPoint::point);
	r_result["point_names"] = names_of(p_content.points);
	r_result["point_flags"] = numbers_of(p_content.points, &mvn::BodyPoint::flags);
	r_result["point_positions"] = vectors_of(p_content.points, &mvn::BodyPoint::position);
}

Dictionary tags_of(const Content &p_content) {
	Dictionary tags;
	for (const auto &[name, value] : p_content.tags) {
		tags[String::utf8(name.c_str())] = String::utf8(value.c_str());
	}
	return tags;
}

void take_motions(DictionaryReader &r_reader, Content &r_content) {
	std::vector<mvn::SegmentMotion> &motions = r_content.motions;
	r_reader.ids("segments", motions, &mvn::SegmentMotion::id, true);
	if (r_content.header.type == Type::LINEAR_KINEMATICS) {
		r_reader.vectors("positions", motions, &mvn::SegmentMotion::position);
		r_reader.vectors("velocities", motions, &mvn::SegmentMotion::velocity);
		r_reader.vectors("accelerations", motions, &mvn::SegmentMotion::acceleration);
		return;
	}
	r_reader.rotations(motions);
	if (r_content.header.type == Type::ANGULAR_KINEMATICS) {
		r_reader.vectors("angular_velocities", motions, &mvn::SegmentMotion::angular_velocity);
		r_reader.vectors("angular_accelerations", motions, &mvn::SegmentMotion::angular_acceleration);
		return;
	}
	r_reader.vectors("free_accelerations", motions, &mvn::SegmentMotion::free_acceleration);
	r_reader.vectors("magnetic_fields", motions, &mvn::SegmentMotion::magnetic_field);
	const bool has_accelerations = r_reader.vectors("accelerations", motions, &mvn::SegmentMotion::acceleration, false);
	const bool has_rates = r_reader.vectors("rates", motions, &mvn::SegmentMotion::rate, false);
	for (mvn::SegmentMotion &motion : motions) {
		motion.is_full = has_accelerations && has_rates;
	}
}

void take_scale(DictionaryReader &r_reader, Content &r_content) {
	Variant value;
	if (r_reader.find("names", Variant::PACKED_STRING_ARRAY, true, value)) {
		r_content.origins.resize(std::size_t(PackedStringArray(value).size()));
	}
	r_reader.names("names", r_content.origins);
	r_reader.vectors("origins", r_content.origins, &mvn::SegmentOrigin::origin);
	if (r_reader.find("point_segments", Variant::PACKED_INT32_ARRAY, false, value)) {
		r_reader.ids("point_segments", r_content.points, &mvn::BodyPoint::segment, true);
		r_reader.ids("point_numbers", r_content.points, &mvn::BodyPoint::point, false);
		r_reader.names("point_names", r_content.points);
		r_reader.ids("point_flags", r_content.points, &mvn::BodyPoint::flags, false);
		r_reader.vectors("point_positions", r_content.points, &mvn::BodyPoint::position);
	}
}

void take_tags(DictionaryReader &r_reader, Content &r_content) {
	Variant value;
	if (!r_reader.find("tags", Variant::DICTIONARY, true, value)) {
		return;
	}
	const Dictionary tags = value;
	const Array names = tags.keys();
	r_content.tags.reserve(std::size_t(names.size()));
	for (int64_t at = 0; at < names.size(); ++at) {
		const Variant text = tags.get(names[at], Variant());
		if (names[at].get_type() != Variant::STRING || text.get_type() != Variant::STRING) {
			r_reader.fail("tags and their values are texts");
			return;
		}
		r_content.tags.emplace_back(String(names[at]).utf8().get_data(), String(text).utf8().get_data());
	}
}

void take_body(DictionaryReader &r_reader, Content &r_content) {
	Variant value;
	switch (r_content.header.type) {
		case Type::EULER_POSE:
		case Type::POSE:
		case Type::UNITY_POSE:
		case Type::POINTS:
			r_reader.ids("segments", r_content.poses, &mvn::SegmentPose::id, true);
			r_reader.vectors("positions", r_content.poses, &mvn::SegmentPose::position);
			if (r_content.header.type == Type::EULER_POSE) {
				r_reader.vectors("euler", r_content.poses, &mvn::SegmentPose::euler);
			} else if (r_content.header.type != Type::POINTS) {
				r_reader.rotations(r_content.poses);
			}
			break;
		case Type::META:
			take_tags(r_reader, r_content);
			break;
		case Type::SCALE:
			take_scale(r_reader, r_content);
			break;
		case Type::JOINT_ANGLES:
			r_reader.ids("parents", r_content.joints, &mvn::JointAngle::parent_point, true);
			r_reader.ids("children", r_content.joints, &mvn::JointAngle::child_point, false);
			r_reader.vectors("angles", r_content.joints, &mvn::JointAngle::angles);
			break;
		case Type::LINEAR_KINEMATICS:
		case Type::ANGULAR_KINEMATICS:
		case Type::TRACKERS:
			take_motions(r_reader, r_content);
			break;
		case Type::CENTRE_OF_MASS:
			if (r_reader.find("centre_of_mass", Variant::VECTOR3, true, value)) {
				const Vector3 centre = value;
				r_content.centre_of_mass = { float(centre.x), float(centre.y), float(centre.z) };
			}
			break;
		case Type::TIME_CODE:
			if (r_reader.find("time_code", Variant::STRING, true, value)) {
				r_content.time_code = String(value).utf8().get_data();
			}
			break;
		default:
			r_reader.fail("there is no such type");
	}
}

} // namespace

Dictionary mvn_to_dictionary(const Content &p_content) {
	const mvn::Header &header = p_content.header;
	Dictionary result;
	result["type"] = int64_t(header.type);
	result["sample"] = int64_t(header.sample);
	result["time_code_ms"] = int64_t(header.time_code_ms);
	result["character"] = int64_t(header.character);
	result["props"] = int64_t(header.props);
	result["fingers"] = int64_t(header.fingers);
	switch (header.type) {
		case Type::EULER_POSE:
		case Type::POSE:
		case Type::UNITY_POSE:
		case Type::POINTS:
			result["segments"] = numbers_of(p_content.poses, &mvn::SegmentPose::id);
			result["positions"] = vectors_of(p_content.poses, &mvn::SegmentPose::position);
			if (header.type == Type::EULER_POSE) {
				result["euler"] = vectors_of(p_content.poses, &mvn::SegmentPose::euler);
			} else if (header.type != Type::POINTS) {
				put_rotations(p_content.poses, result);
			}
			break;
		case Type::META:
			result["tags"] = tags_of(p_content);
			break;
		case Type::SCALE:
			put_scale(p_content, result);
			break;
		case Type::JOINT_ANGLES:
			result["parents"] = numbers_of(p_content.joints, &mvn::JointAngle::parent_point);
			result["children"] = numbers_of(p_content.joints, &mvn::JointAngle::child_point);
			result["angles"] = vectors_of(p_content.joints, &mvn::JointAngle::angles);
			break;
		case Type::LINEAR_KINEMATICS:
		case Type::ANGULAR_KINEMATICS:
		case Type::TRACKERS:
			put_motions(p_content, result);
			break;
		case Type::CENTRE_OF_MASS:
			result["centre_of_mass"] =
					Vector3(p_content.centre_of_mass[0], p_content.centre_of_mass[1], p_content.centre_of_mass[2]);
			break;
		case Type::TIME_CODE:
			result["time_code"] = String::utf8(p_content.time_code.c_str());
			break;
	}
	return result;
}

String mvn_from_dictionary(const Dictionary &p_sample, Content &r_content) {
	constexpr int64_t MAX_U32 = std::numeric_limits<uint32_t>::max();
	DictionaryReader reader(p_sample);
	mvn::Header &header = r_content.header;
	header.type = Type(reader.number("type", true, 99));
	header.sample = uint32_t(reader.number("sample", true, MAX_U32));
	header.time_code_ms = uint32_t(reader.number("time_code_ms", false, MAX_U32));
	header.character = uint8_t(reader.number("character", false, 255));
	header.body_segments = mvn::BODY_SEGMENTS;
	header.props = uint8_t(reader.number("props", false, mvn::MAX_PROPS));
	header.fingers = uint8_t(reader.number("fingers", false, mvn::FINGER_SEGMENTS));
	if (reader.fault().is_empty()) {
		take_body(reader, r_content);
	}
	return reader.fault();
}

} // namespace godot
