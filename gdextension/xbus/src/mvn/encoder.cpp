// SPDX-License-Identifier: MIT
#include "mvn/encoder.hpp"

#include "bus/bytes.hpp"

#include <algorithm>
#include <cstring>

namespace mvn {

namespace {

/// The head has a byte for the number of items.
constexpr std::size_t MAX_ITEMS = 255;

/// A payload that grows.
class PayloadWriter {
public:
	void u8(unsigned p_value) { _bytes.push_back(uint8_t(p_value)); }
	void u16(unsigned p_value) {
		u8(p_value >> 8U);
		u8(p_value);
	}
	void u32(uint32_t p_value) {
		u16(p_value >> 16U);
		u16(p_value);
	}
	void real(float p_value) {
		uint32_t bits = 0;
		std::memcpy(&bits, &p_value, sizeof(bits));
		u32(bits);
	}
	template <std::size_t Size>
	void reals(const std::array<float, Size> &p_values) {
		for (const float value : p_values) {
			real(value);
		}
	}
	void text(const std::string &p_text) {
		u32(uint32_t(p_text.size()));
		raw(p_text);
	}
	void raw(const std::string &p_text) { _bytes.insert(_bytes.end(), p_text.begin(), p_text.end()); }
	Bytes &bytes() { return _bytes; }

private:
	Bytes _bytes;
};

/// A part of a sample: so many items, and their bytes.
struct Portion {
	std::size_t items = 0;
	Bytes payload;
};

void write_pose(const SegmentPose &p_pose, Type p_type, PayloadWriter &r_writer) {
	r_writer.u32(uint32_t(p_pose.id));
	r_writer.reals(p_pose.position);
	if (p_type == Type::EULER_POSE) {
		r_writer.reals(p_pose.euler);
	} else if (p_type != Type::POINTS) {
		r_writer.reals(p_pose.has_rotation ? p_pose.rotation : Quaternion{});
	}
}

void write_motion(const SegmentMotion &p_motion, Type p_type, PayloadWriter &r_writer) {
	r_writer.u32(uint32_t(p_motion.id));
	if (p_type == Type::LINEAR_KINEMATICS) {
		r_writer.reals(p_motion.position);
		r_writer.reals(p_motion.velocity);
		r_writer.reals(p_motion.acceleration);
		return;
	}
	r_writer.reals(p_motion.has_rotation ? p_motion.rotation : Quaternion{});
	if (p_type == Type::ANGULAR_KINEMATICS) {
		r_writer.reals(p_motion.angular_velocity);
		r_writer.reals(p_motion.angular_acceleration);
		return;
	}
	r_writer.reals(p_motion.free_acceleration);
	if (p_motion.is_full) {
		r_writer.reals(p_motion.acceleration);
		r_writer.reals(p_motion.rate);
	}
	r_writer.reals(p_motion.magnetic_field);
}

void write_joint(const JointAngle &p_joint, PayloadWriter &r_writer) {
	r_writer.u32(uint32_t(p_joint.parent_point));
	r_writer.u32(uint32_t(p_joint.child_point));
	r_writer.reals(p_joint.angles);
}

/// Cuts a list of items into portions that fit a datagram each.
template <class Item, class Write>
std::vector<Portion> cut(const std::vector<Item> &p_items, std::size_t p_most, Write &&p_write) {
	std::vector<Portion> portions(1);
	for (const Item &item : p_items) {
		PayloadWriter writer;
		p_write(item, writer);
		Portion *last = &portions.back();
		if (last->items == MAX_ITEMS ||
				(last->items > 0 && HEADER_SIZE + last->payload.size() + writer.bytes().size() > p_most)) {
			last = &portions.emplace_back();
		}
		++last->items;
		last->payload.insert(last->payload.end(), writer.bytes().begin(), writer.bytes().end());
	}
	return portions;
}

/// First all segments, then the points, as MVN does.
std::vector<Portion> cut_scale(const Content &p_content, std::size_t p_most) {
	std::vector<Portion> portions;
	PayloadWriter segments;
	segments.u32(uint32_t(p_content.origins.size()));
	for (const SegmentOrigin &origin : p_content.origins) {
		segments.text(origin.name);
		segments.reals(origin.origin);
	}
	segments.u32(0);
	portions.push_back({ p_content.origins.size(), segments.bytes() });
	const auto write = [](const BodyPoint &p_point, PayloadWriter &r_writer) {
		r_writer.u16(p_point.segment);
		r_writer.u16(p_point.point);
		r_writer.text(p_point.name);
		r_writer.u32(p_point.flags);
		r_writer.reals(p_point.position);
	};
	constexpr std::size_t COUNTS = 8;
	for (const Portion &points : cut(p_content.points, p_most - COUNTS, write)) {
		if (points.items > 0) {
			PayloadWriter writer;
			writer.u32(0);
			writer.u32(uint32_t(points.items));
			writer.bytes().insert(writer.bytes().end(), points.payload.begin(), points.payload.end());
			portions.push_back({ points.items, writer.bytes() });
		}
	}
	return portions;
}

std::vector<Portion> portions_of(const Content &p_content, std::size_t p_most) {
	const Type type = p_content.header.type;
	PayloadWriter writer;
	switch (type) {
		case Type::EULER_POSE:
		case Type::POSE:
		case Type::POINTS:
		case Type::UNITY_POSE:
			return cut(p_content.poses, p_most,
					[type](const SegmentPose &p_pose, PayloadWriter &r_writer) { write_pose(p_pose, type, r_writer); });
		case Type::JOINT_ANGLES:
			return cut(p_content.joints, p_most, write_joint);
		case Type::LINEAR_KINEMATICS:
		case Type::ANGULAR_KINEMATICS:
		case Type::TRACKERS:
			return cut(p_content.motions, p_most, [type](const SegmentMotion &p_motion, PayloadWriter &r_writer) {
				write_motion(p_motion, type, r_writer);
			});
		case Type::SCALE:
			return cut_scale(p_content, p_most);
		case Type::META:
			for (const auto &[name, value] : p_content.tags) {
				writer.raw(name);
				writer.raw(":");
				writer.raw(value);
				writer.raw("\n");
			}
			return { { p_content.tags.size(), writer.bytes() } };
		case Type::CENTRE_OF_MASS:
			writer.reals(p_content.centre_of_mass);
			return { { 1, writer.bytes() } };
		case Type::TIME_CODE:
			writer.raw(p_content.time_code);
			return { { 1, writer.bytes() } };
		default:
			return {};
	}
}

} // namespace

std::vector<Bytes> encode(const Content &p_content, std::size_t p_most) {
	const std::vector<Portion> portions = portions_of(p_content, std::max<std::size_t>(p_most, 128));
	std::vector<Bytes> datagrams;
	if (portions.size() > std::size_t(MAX_PARTS)) {
		return datagrams;
	}
	const Header &header = p_content.header;
	datagrams.reserve(portions.size());
	for (std::size_t part = 0; part < portions.size(); ++part) {
		const Portion &portion = portions[part];
		if (portion.items > MAX_ITEMS) {
			return {};
		}
		PayloadWriter writer;
		const auto type = unsigned(header.type);
		writer.raw("MXTP");
		writer.u8('0' + type / 10);
		writer.u8('0' + type % 10);
		writer.u32(header.sample);
		writer.u8(unsigned(part) | (part + 1 == portions.size() ? 0x80U : 0U));
		writer.u8(unsigned(portion.items));
		writer.u32(header.time_code_ms);
		writer.u8(header.character);
		writer.u8(header.body_segments);
		writer.u8(header.props);
		writer.u8(header.fingers);
		writer.u16(0);
		writer.u16(unsigned(portion.payload.size()));
		writer.bytes().insert(writer.bytes().end(), portion.payload.begin(), portion.payload.end());
		datagrams.push_back(writer.bytes());
	}
	return datagrams;
}

} // namespace mvn
