// SPDX-License-Identifier: MIT
#include "mvn/datagram.hpp"

#include "mvn/payload_reader.hpp"

#include <cmath>
#include <cstring>

namespace mvn {

const std::array<const char *, BODY_SEGMENTS> SEGMENT_NAMES = { "Pelvis", "L5", "L3", "T12", "T8", "Neck", "Head",
	"RightShoulder", "RightUpperArm", "RightForearm", "RightHand", "LeftShoulder", "LeftUpperArm", "LeftForearm",
	"LeftHand", "RightUpperLeg", "RightLowerLeg", "RightFoot", "RightToe", "LeftUpperLeg", "LeftLowerLeg", "LeftFoot",
	"LeftToe" };

const std::array<uint8_t, BODY_SEGMENTS> UNITY_ORDER = { 0, 15, 16, 17, 18, 19, 20, 21, 22, 1, 2, 3, 4, 11, 12, 13, 14,
	7, 8, 9, 10, 5, 6 };

namespace {

constexpr std::size_t EULER_ITEM = 28;
constexpr std::size_t POSE_ITEM = 32;
constexpr std::size_t POINT_ITEM = 16;
constexpr std::size_t JOINT_ITEM = 20;
constexpr std::size_t LINEAR_ITEM = 40;
constexpr std::size_t ANGULAR_ITEM = 44;
constexpr std::size_t TRACKER_ITEM = 68;
constexpr std::size_t CENTRE_SIZE = 12;
constexpr std::size_t TIME_CODE_SIZE = 12;
/// How far from 1 the length of a quaternion may be.
constexpr float MAX_NORM_ERROR = 0.05F;
constexpr int MAX_TEXT = 256;
constexpr int MAX_TAGS = 64;
constexpr int MAX_POINTS = 512;
/// Joints of a body with fingers, and more.
constexpr int MAX_JOINTS = 128;

bool is_known(int p_type) {
	switch (Type(p_type)) {
		case Type::EULER_POSE:
		case Type::POSE:
		case Type::POINTS:
		case Type::UNITY_POSE:
		case Type::META:
		case Type::SCALE:
		case Type::JOINT_ANGLES:
		case Type::LINEAR_KINEMATICS:
		case Type::ANGULAR_KINEMATICS:
		case Type::TRACKERS:
		case Type::CENTRE_OF_MASS:
		case Type::TIME_CODE:
			return true;
	}
	return false;
}

/// All zeros stand for a rotation that is not known: takes them out. Returns whether there was one.
bool take_rotation(Quaternion &r_rotation) {
	if (r_rotation != Quaternion{}) {
		return true;
	}
	r_rotation = { 1.0F, 0.0F, 0.0F, 0.0F };
	return false;
}

bool is_rotation(const Quaternion &p_rotation) {
	float norm = 0.0F;
	for (const float part : p_rotation) {
		norm += part * part;
	}
	// Written so that NaN fails too.
	return std::fabs(std::sqrt(norm) - 1.0F) < MAX_NORM_ERROR;
}

/// Reads items of one size, each by `p_read(PayloadReader &)`, which says whether its values can be.
template <class Read>
Fault read_items(PayloadReader &p_reader, int p_items, std::size_t p_item_size, Read &&p_read) {
	if (p_reader.left() != std::size_t(p_items) * p_item_size) {
		return Fault::WRONG_SIZE;
	}
	for (int item = 0; item < p_items; ++item) {
		if (!p_read(p_reader) || !p_reader.is_finite()) {
			return Fault::BAD_VALUE;
		}
	}
	return Fault::NONE;
}

Fault read_poses(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	if (r_content.poses.size() + p_header.items > std::size_t(MAX_SEGMENTS)) {
		return Fault::TOO_MANY;
	}
	const bool is_euler = p_header.type == Type::EULER_POSE;
	return read_items(p_reader, p_header.items, is_euler ? EULER_ITEM : POSE_ITEM, [&](PayloadReader &p_from) {
		SegmentPose pose;
		pose.id = p_from.read_i32();
		pose.position = p_from.read_vector();
		if (is_euler) {
			pose.euler = p_from.read_vector();
		} else {
			pose.rotation = p_from.read_quaternion();
			const bool may_lack = r_content.poses.size() >= std::size_t(BODY_SEGMENTS);
			pose.has_rotation = !may_lack || take_rotation(pose.rotation);
		}
		r_content.poses.push_back(pose);
		return is_euler || is_rotation(pose.rotation);
	});
}

Fault read_points(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	if (r_content.poses.size() + p_header.items > std::size_t(MAX_POINTS)) {
		return Fault::TOO_MANY;
	}
	return read_items(p_reader, p_header.items, POINT_ITEM, [&](PayloadReader &p_from) {
		SegmentPose point;
		point.id = p_from.read_i32();
		point.position = p_from.read_vector();
		point.has_rotation = false;
		r_content.poses.push_back(point);
		return true;
	});
}

Fault read_joints(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	if (r_content.joints.size() + p_header.items > std::size_t(MAX_JOINTS)) {
		return Fault::TOO_MANY;
	}
	return read_items(p_reader, p_header.items, JOINT_ITEM, [&](PayloadReader &p_from) {
		JointAngle joint;
		joint.parent_point = p_from.read_i32();
		joint.child_point = p_from.read_i32();
		joint.angles = p_from.read_vector();
		r_content.joints.push_back(joint);
		return true;
	});
}

Fault read_linear(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	return read_items(p_reader, p_header.items, LINEAR_ITEM, [&](PayloadReader &p_from) {
		SegmentMotion motion;
		motion.id = p_from.read_i32();
		motion.position = p_from.read_vector();
		motion.velocity = p_from.read_vector();
		motion.acceleration = p_from.read_vector();
		r_content.motions.push_back(motion);
		return true;
	});
}

Fault read_angular(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	return read_items(p_reader, p_header.items, ANGULAR_ITEM, [&](PayloadReader &p_from) {
		SegmentMotion motion;
		motion.id = p_from.read_i32();
		motion.rotation = p_from.read_quaternion();
		motion.has_rotation = take_rotation(motion.rotation);
		motion.angular_velocity = p_from.read_vector();
		motion.angular_acceleration = p_from.read_vector();
		r_content.motions.push_back(motion);
		return is_rotation(motion.rotation);
	});
}

/// Xsens' own list of fields and their own code differ: the size of the items shows which form it is.
Fault read_trackers(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	const bool is_full = p_header.items > 0 && p_reader.left() / p_header.items == TRACKER_ITEM;
	return read_items(p_reader, p_header.items, is_full ? TRACKER_ITEM : ANGULAR_ITEM, [&](PayloadReader &p_from) {
		SegmentMotion motion;
		motion.id = p_from.read_i32();
		motion.rotation = p_from.read_quaternion();
		motion.has_rotation = take_rotation(motion.rotation);
		motion.free_acceleration = p_from.read_vector();
		motion.is_full = is_full;
		if (is_full) {
			motion.acceleration = p_from.read_vector();
			motion.rate = p_from.read_vector();
		}
		motion.magnetic_field = p_from.read_vector();
		r_content.motions.push_back(motion);
		return is_rotation(motion.rotation);
	});
}

Fault read_motions(const Header &p_header, PayloadReader &p_reader, Content &r_content) {
	if (r_content.motions.size() + p_header.items > std::size_t(MAX_SEGMENTS)) {
		return Fault::TOO_MANY;
	}
	switch (p_header.type) {
		case Type::LINEAR_KINEMATICS:
			return read_linear(p_header, p_reader, r_content);
		case Type::ANGULAR_KINEMATICS:
			return read_angular(p_header, p_reader, r_content);
		default:
			return read_trackers(p_header, p_reader, r_content);
	}
}

Fault read_meta(PayloadReader &p_reader, Content &r_content) {
	const std::string text = p_reader.read_rest();
	std::size_t at = 0;
	while (at < text.size() && r_content.tags.size() < std::size_t(MAX_TAGS)) {
		const std::size_t end = std::min(text.find('\n', at), text.size());
		const std::string line = text.substr(at, end - at);
		const std::size_t colon = line.find(':');
		if (colon != std::string::npos && colon > 0) {
			r_content.tags.emplace_back(
					cut_text(line.substr(0, colon), MAX_TEXT), cut_text(line.substr(colon + 1), MAX_TEXT));
		}
		at = end + 1;
	}
	return Fault::NONE;
}

Fault read_scale(PayloadReader &p_reader, Content &r_content) {
	const int32_t segments = p_reader.read_i32();
	if (segments < 0 || segments > MAX_SEGMENTS) {
		return p_reader.has_failed() ? Fault::WRONG_SIZE : Fault::TOO_MANY;
	}
	for (int32_t segment = 0; segment < segments && !p_reader.has_failed(); ++segment) {
		SegmentOrigin origin;
		origin.name = p_reader.read_text(MAX_TEXT);
		origin.origin = p_reader.read_vector();
		r_content.origins.push_back(origin);
	}
	const int32_t points = p_reader.read_i32();
	if (points < 0 || points > MAX_POINTS || r_content.points.size() + std::size_t(points) > std::size_t(MAX_POINTS) ||
			r_content.origins.size() > std::size_t(MAX_SEGMENTS)) {
		return p_reader.has_failed() ? Fault::WRONG_SIZE : Fault::TOO_MANY;
	}
	for (int32_t number = 0; number < points && !p_reader.has_failed(); ++number) {
		BodyPoint point;
		point.segment = p_reader.read_u16();
		point.point = p_reader.read_u16();
		point.name = p_reader.read_text(MAX_TEXT);
		point.flags = p_reader.read_u32();
		point.position = p_reader.read_vector();
		r_content.points.push_back(point);
	}
	if (p_reader.has_failed() || p_reader.left() != 0) {
		return Fault::WRONG_SIZE;
	}
	return p_reader.is_finite() ? Fault::NONE : Fault::BAD_VALUE;
}

/// Xsens' description has 12 characters, their code a length before them.
Fault read_time_code(PayloadReader &p_reader, Content &r_content) {
	if (p_reader.left() == TIME_CODE_SIZE + 4 && p_reader.read_i32() != int32_t(TIME_CODE_SIZE)) {
		return Fault::BAD_VALUE;
	}
	if (p_reader.left() != TIME_CODE_SIZE) {
		return Fault::WRONG_SIZE;
	}
	r_content.time_code = p_reader.read_rest();
	constexpr const char *FORM = "00:00:00.000";
	for (std::size_t at = 0; at < TIME_CODE_SIZE; ++at) {
		const char found = r_content.time_code[at];
		const bool fits = FORM[at] == '0' ? found >= '0' && found <= '9' : found == FORM[at];
		if (!fits) {
			return Fault::BAD_VALUE;
		}
	}
	return Fault::NONE;
}

} // namespace

const char *fault_text(Fault p_fault) {
	switch (p_fault) {
		case Fault::NONE:
			return "nothing";
		case Fault::TOO_SHORT:
			return "shorter than a head";
		case Fault::NOT_MXTP:
			return "not of MVN's form (MXTP)";
		case Fault::UNKNOWN_TYPE:
			return "of an unknown type";
		case Fault::WRONG_SIZE:
			return "its size does not fit what it says it holds";
		case Fault::TOO_MANY:
			return "more segments than a character has";
		case Fault::BAD_VALUE:
			return "numbers that cannot be";
		case Fault::BAD_PARTS:
			return "the parts of a sample do not fit each other";
	}
	return "unknown";
}

Fault read_header(const uint8_t *p_bytes, std::size_t p_size, Header &r_header) {
	if (p_size < HEADER_SIZE) {
		return Fault::TOO_SHORT;
	}
	const int tens = p_bytes[4] - '0';
	const int ones = p_bytes[5] - '0';
	if (std::memcmp(p_bytes, "MXTP", 4) != 0 || tens < 0 || tens > 9 || ones < 0 || ones > 9) {
		return Fault::NOT_MXTP;
	}
	if (!is_known(tens * 10 + ones)) {
		return Fault::UNKNOWN_TYPE;
	}
	r_header.type = Type(tens * 10 + ones);
	PayloadReader reader(p_bytes + 6, HEADER_SIZE - 6);
	r_header.sample = reader.read_u32();
	const unsigned part = reader.read_u8();
	r_header.part = uint8_t(part & 0x7FU);
	r_header.is_last = (part & 0x80U) != 0;
	r_header.items = reader.read_u8();
	r_header.time_code_ms = reader.read_u32();
	r_header.character = reader.read_u8();
	r_header.body_segments = reader.read_u8();
	r_header.props = reader.read_u8();
	r_header.fingers = reader.read_u8();
	reader.read_u16();
	r_header.payload = reader.read_u16();
	if (r_header.payload != 0 && r_header.payload != p_size - HEADER_SIZE) {
		return Fault::WRONG_SIZE;
	}
	if (r_header.body_segments + r_header.props + r_header.fingers > MAX_SEGMENTS) {
		return Fault::TOO_MANY;
	}
	return Fault::NONE;
}

Fault read_payload(const Header &p_header, const uint8_t *p_payload, std::size_t p_size, Content &r_content) {
	PayloadReader reader(p_payload, p_size);
	switch (p_header.type) {
		case Type::EULER_POSE:
		case Type::POSE:
		case Type::UNITY_POSE:
			return read_poses(p_header, reader, r_content);
		case Type::POINTS:
			return read_points(p_header, reader, r_content);
		case Type::META:
			return read_meta(reader, r_content);
		case Type::SCALE:
			return read_scale(reader, r_content);
		case Type::JOINT_ANGLES:
			return read_joints(p_header, reader, r_content);
		case Type::LINEAR_KINEMATICS:
		case Type::ANGULAR_KINEMATICS:
		case Type::TRACKERS:
			return read_motions(p_header, reader, r_content);
		case Type::CENTRE_OF_MASS:
			// Newer versions of MVN add more behind it.
			if (p_size < CENTRE_SIZE) {
				return Fault::WRONG_SIZE;
			}
			r_content.centre_of_mass = reader.read_vector();
			return reader.is_finite() ? Fault::NONE : Fault::BAD_VALUE;
		case Type::TIME_CODE:
			return read_time_code(reader, r_content);
	}
	return Fault::UNKNOWN_TYPE;
}

} // namespace mvn
