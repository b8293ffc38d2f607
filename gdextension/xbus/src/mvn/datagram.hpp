// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// MVN's network stream (MXTP, docs/mvn.md): datagrams, their parts put together, and what they hold.
/// Axes and units stay those of the stream.
namespace mvn {

constexpr std::size_t HEADER_SIZE = 24;
/// The largest that UDP carries.
constexpr std::size_t MAX_DATAGRAM = 65507;
constexpr int BODY_SEGMENTS = 23;
constexpr int MAX_PROPS = 4;
constexpr int FINGER_SEGMENTS = 40;
constexpr int MAX_SEGMENTS = BODY_SEGMENTS + MAX_PROPS + FINGER_SEGMENTS;
/// Datagrams of a sample: the index has seven bits.
constexpr int MAX_PARTS = 128;

/// What a datagram holds, by the two digits in its head.
enum class Type : uint8_t {
	EULER_POSE = 1, ///< Y up, right-handed, cm, degrees.
	POSE = 2, ///< Quaternions; Z up, right-handed, m.
	POINTS = 3, ///< Positions of points on the body; Y up, right-handed, cm.
	UNITY_POSE = 5, ///< Y up, left-handed, m; only pelvis and props are global.
	META = 12, ///< Name, colour and the like of a character.
	SCALE = 13, ///< The null pose: where segments begin, and their points.
	JOINT_ANGLES = 20,
	LINEAR_KINEMATICS = 21,
	ANGULAR_KINEMATICS = 22,
	TRACKERS = 23, ///< What each tracker measures.
	CENTRE_OF_MASS = 24,
	TIME_CODE = 25,
};

/// Whether a type holds motion: of all else the newest is enough.
inline bool is_motion(Type p_type) {
	return p_type == Type::POSE || p_type == Type::EULER_POSE || p_type == Type::UNITY_POSE || p_type == Type::TRACKERS;
}

/// Why a datagram was refused.
enum class Fault : uint8_t {
	NONE,
	TOO_SHORT, ///< Not even a head.
	NOT_MXTP, ///< Does not begin with MXTP and two digits.
	UNKNOWN_TYPE,
	WRONG_SIZE, ///< Payload and number of items do not fit each other.
	TOO_MANY, ///< More segments than a character can have.
	BAD_VALUE, ///< Not finite, no rotation, or a number that cannot be.
	BAD_PARTS, ///< The parts of a sample do not fit each other.
};
constexpr int FAULTS = 8;
const char *fault_text(Fault p_fault);

/// The head of a datagram.
struct Header {
	Type type = Type::POSE;
	/// Number of the sample; a sender may leave some out.
	uint32_t sample = 0;
	/// Which of the sample's datagrams this is, from 0.
	uint8_t part = 0;
	bool is_last = false;
	uint8_t items = 0;
	/// Since the recording began, ms.
	uint32_t time_code_ms = 0;
	uint8_t character = 0;
	/// 0 from senders before MVN 2019, as the three that follow.
	uint8_t body_segments = 0;
	uint8_t props = 0;
	uint8_t fingers = 0;
	uint16_t payload = 0;
};

/// Reads the head of a datagram, and checks it against the datagram's size.
Fault read_header(const uint8_t *p_bytes, std::size_t p_size, Header &r_header);

using Vector = std::array<float, 3>;
/// w, x, y, z.
using Quaternion = std::array<float, 4>;

/// A segment's position and rotation (types 01, 02 and 05), or a point's position (type 03).
struct SegmentPose {
	int32_t id = 0;
	Vector position{};
	Quaternion rotation{ 1.0F, 0.0F, 0.0F, 0.0F };
	/// Type 01: about X, Y and Z, degrees.
	Vector euler{};
	/// Whether it has a rotation: all zeros stand for a prop or a finger that is not tracked.
	bool has_rotation = true;
};

/// Type 20: the three angles between two points, degrees.
struct JointAngle {
	int32_t parent_point = 0;
	int32_t child_point = 0;
	Vector angles{};
};

/// Types 21, 22 and 23: what is known of a segment's motion.
struct SegmentMotion {
	int32_t id = 0;
	Vector position{};
	Vector velocity{};
	Vector acceleration{};
	Quaternion rotation{ 1.0F, 0.0F, 0.0F, 0.0F };
	Vector angular_velocity{};
	Vector angular_acceleration{};
	/// Of trackers: without gravity in the world's frame, with it in the tracker's, m/s2.
	Vector free_acceleration{};
	/// Of trackers: rad/s, and the earth's field, in the tracker's axes.
	Vector rate{};
	Vector magnetic_field{};
	/// Whether acceleration and rate of a tracker are there: the shorter form lacks them.
	bool is_full = false;
	/// Whether it has a rotation: all zeros stand for a segment without a tracker.
	bool has_rotation = true;
};

/// Type 13: where a segment begins in the null pose, m.
struct SegmentOrigin {
	std::string name;
	Vector origin{};
};

/// Type 13: a point on a segment, m from where that begins.
struct BodyPoint {
	uint16_t segment = 0;
	uint16_t point = 0;
	std::string name;
	uint32_t flags = 0;
	Vector position{};
};

/// What a whole sample of one type holds; of its lists only that of the type is filled.
struct Content {
	Header header;
	std::vector<SegmentPose> poses;
	std::vector<JointAngle> joints;
	std::vector<SegmentMotion> motions;
	std::vector<SegmentOrigin> origins;
	std::vector<BodyPoint> points;
	/// Type 12: tag and value, unknown tags too.
	std::vector<std::pair<std::string, std::string>> tags;
	/// Type 24, m.
	Vector centre_of_mass{};
	/// Type 25, "HH:MM:SS.mmm".
	std::string time_code;
};

/// Reads the payload of one datagram and adds what it holds. On a fault what was added is invalid.
Fault read_payload(const Header &p_header, const uint8_t *p_payload, std::size_t p_size, Content &r_content);

/// The names of MVN's body segments in the order of types 01 and 02 (segment id less one).
extern const std::array<const char *, BODY_SEGMENTS> SEGMENT_NAMES;
/// For each segment of type 05 its index among those of types 01 and 02.
extern const std::array<uint8_t, BODY_SEGMENTS> UNITY_ORDER;

} // namespace mvn
