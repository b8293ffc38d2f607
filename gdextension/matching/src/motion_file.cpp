// SPDX-License-Identifier: MIT
#include "motion_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace matching {

namespace {

// Layout: "DMMS", u16 version, u16 clips; for each clip: u8 length of its name and the name, u8 stance, u32 frames,
// f32 height of the ankles, f32 length of the feet; then its frames, each FRAME_BYTES: numbers as i16.
constexpr char MAGIC[4] = { 'D', 'M', 'M', 'S' };
constexpr uint16_t VERSION = 1;
constexpr std::size_t MAX_CLIPS = 1000;
constexpr std::size_t MAX_FRAMES = 100000;
/// Steps of a height of the hips, of a speed and of a rotation.
constexpr float PLACES_PER_UNIT = 8192.0f;
constexpr float SPEEDS_PER_UNIT = 1024.0f;
constexpr float TURNS_PER_UNIT = 32000.0f;
/// What is further from a frame's origin, in heights of the hips, or faster, in heights and rad a second, is no person.
constexpr float FARTHEST_HIPS = 1.5f;
constexpr float FARTHEST_ANKLE = 2.5f;
constexpr float FASTEST = 15.0f;
constexpr std::size_t NUMBERS = 9 + 3 + 4 * LIMBS;
constexpr std::size_t FRAME_BYTES = NUMBERS * 2 + 1;

class Writer {
public:
	std::vector<uint8_t> bytes;

	template <typename T>
	void put(T p_value) {
		uint8_t raw[sizeof(T)];
		std::memcpy(raw, &p_value, sizeof(T));
		bytes.insert(bytes.end(), raw, raw + sizeof(T));
	}
	void put_scaled(float p_value, float p_steps) {
		put(int16_t(std::lround(std::clamp(p_value * p_steps, -32767.0f, 32767.0f))));
	}
	void put_place(const Vec3 &p_place) {
		for (const float value : { p_place.x, p_place.y, p_place.z }) {
			put_scaled(value, PLACES_PER_UNIT);
		}
	}
};

class Reader {
public:
	Reader(const uint8_t *p_bytes, std::size_t p_size) : _bytes(p_bytes), _left(p_size) {}

	std::size_t left() const { return _left; }
	/// Zero where nothing is left.
	template <typename T>
	T take() {
		T value{};
		if (_left < sizeof(T)) {
			_left = 0;
			_is_short = true;
			return value;
		}
		std::memcpy(&value, _bytes, sizeof(T));
		skip(sizeof(T));
		return value;
	}
	float take_scaled(float p_steps) { return float(take<int16_t>()) / p_steps; }
	Vec3 take_place() {
		Vec3 place;
		place.x = take_scaled(PLACES_PER_UNIT);
		place.y = take_scaled(PLACES_PER_UNIT);
		place.z = take_scaled(PLACES_PER_UNIT);
		return place;
	}
	std::string take_text(std::size_t p_length) {
		const std::size_t length = std::min(p_length, _left);
		_is_short = _is_short || length < p_length;
		std::string text(reinterpret_cast<const char *>(_bytes), length);
		skip(length);
		return text;
	}
	bool is_short() const { return _is_short; }

private:
	void skip(std::size_t p_count) {
		_bytes += p_count;
		_left -= p_count;
	}

	const uint8_t *_bytes;
	std::size_t _left;
	bool _is_short = false;
};

void write_frame(const ClipFrame &p_frame, Writer &r_writer) {
	r_writer.put_place(p_frame.pose.hips);
	r_writer.put_place(p_frame.pose.ankles[0]);
	r_writer.put_place(p_frame.pose.ankles[1]);
	for (const float value : { p_frame.velocity_x, p_frame.velocity_z, p_frame.turn_rate }) {
		r_writer.put_scaled(value, SPEEDS_PER_UNIT);
	}
	for (const Quat &limb : p_frame.pose.limbs) {
		for (const float value : { limb.x, limb.y, limb.z, limb.w }) {
			r_writer.put_scaled(value, TURNS_PER_UNIT);
		}
	}
	r_writer.put(p_frame.contacts);
}

/// Returns whether the frame is one.
bool read_frame(Reader &r_reader, ClipFrame &r_frame) {
	r_frame.pose.hips = r_reader.take_place();
	r_frame.pose.ankles[0] = r_reader.take_place();
	r_frame.pose.ankles[1] = r_reader.take_place();
	r_frame.velocity_x = r_reader.take_scaled(SPEEDS_PER_UNIT);
	r_frame.velocity_z = r_reader.take_scaled(SPEEDS_PER_UNIT);
	r_frame.turn_rate = r_reader.take_scaled(SPEEDS_PER_UNIT);
	bool is_sound = r_frame.pose.hips.length() < FARTHEST_HIPS;
	for (const Vec3 &ankle : r_frame.pose.ankles) {
		is_sound = is_sound && ankle.length() < FARTHEST_ANKLE;
	}
	for (const float speed : { r_frame.velocity_x, r_frame.velocity_z, r_frame.turn_rate }) {
		is_sound = is_sound && std::fabs(speed) < FASTEST;
	}
	for (Quat &limb : r_frame.pose.limbs) {
		limb.x = r_reader.take_scaled(TURNS_PER_UNIT);
		limb.y = r_reader.take_scaled(TURNS_PER_UNIT);
		limb.z = r_reader.take_scaled(TURNS_PER_UNIT);
		limb.w = r_reader.take_scaled(TURNS_PER_UNIT);
		const float square = limb.dot(limb);
		is_sound = is_sound && square > 0.9f && square < 1.1f;
		limb = is_sound ? limb.normalized() : Quat{};
	}
	r_frame.contacts = r_reader.take<uint8_t>();
	return is_sound && r_frame.contacts < 4;
}

std::string read_clip(Reader &r_reader, std::size_t &r_frames, Clip &r_clip) {
	r_clip.name = r_reader.take_text(r_reader.take<uint8_t>());
	const bool is_plain = std::all_of(
			r_clip.name.begin(), r_clip.name.end(), [](char p_letter) { return p_letter >= ' ' && p_letter <= '~'; });
	const uint8_t stance = r_reader.take<uint8_t>();
	const uint32_t frames = r_reader.take<uint32_t>();
	r_clip.ankle_height = r_reader.take<float>();
	r_clip.foot = r_reader.take<float>();
	if (r_reader.is_short()) {
		return "the motion set ends within a clip's head";
	}
	if (!is_plain || stance >= STANCES) {
		return "a clip's name or stance is none";
	}
	// Comparisons that NaN fails, too.
	if (!(r_clip.ankle_height > 0.0f && r_clip.ankle_height < 0.5f && r_clip.foot > 0.0f && r_clip.foot < 0.5f)) {
		return "clip " + r_clip.name + " has feet of no person";
	}
	r_frames += frames;
	if (frames < 2 || r_frames > MAX_FRAMES) {
		return "clip " + r_clip.name + " has too few or too many frames";
	}
	if (r_reader.left() / FRAME_BYTES < frames) {
		return "the motion set ends within clip " + r_clip.name;
	}
	r_clip.stance = Stance(stance);
	r_clip.frames.resize(frames);
	for (ClipFrame &frame : r_clip.frames) {
		if (!read_frame(r_reader, frame)) {
			return "clip " + r_clip.name + " has a frame that is no pose";
		}
	}
	return "";
}

} // namespace

std::vector<uint8_t> write_motion_file(const std::vector<Clip> &p_clips) {
	Writer writer;
	writer.bytes.assign(MAGIC, MAGIC + 4);
	writer.put(VERSION);
	writer.put(uint16_t(std::min(p_clips.size(), MAX_CLIPS)));
	for (std::size_t i = 0; i < std::min(p_clips.size(), MAX_CLIPS); i++) {
		const Clip &clip = p_clips[i];
		const std::string name = clip.name.substr(0, 255);
		writer.put(uint8_t(name.size()));
		writer.bytes.insert(writer.bytes.end(), name.begin(), name.end());
		writer.put(uint8_t(clip.stance));
		writer.put(uint32_t(clip.frames.size()));
		writer.put(clip.ankle_height);
		writer.put(clip.foot);
		for (const ClipFrame &frame : clip.frames) {
			write_frame(frame, writer);
		}
	}
	return writer.bytes;
}

std::string read_motion_file(const uint8_t *p_bytes, std::size_t p_size, std::vector<Clip> &r_clips) {
	r_clips.clear();
	Reader reader(p_bytes, p_size);
	if (p_size < 8 || std::memcmp(p_bytes, MAGIC, 4) != 0) {
		return "this is no motion set";
	}
	reader.take<uint32_t>();
	const uint16_t version = reader.take<uint16_t>();
	if (version != VERSION) {
		return "this is a motion set of version " + std::to_string(version) + ", expected version " +
				std::to_string(VERSION);
	}
	const uint16_t clips = reader.take<uint16_t>();
	if (clips == 0 || clips > MAX_CLIPS) {
		return "a motion set has 1 to " + std::to_string(MAX_CLIPS) + " clips, found " + std::to_string(clips);
	}
	std::vector<Clip> found;
	std::size_t frames = 0;
	for (uint16_t i = 0; i < clips; i++) {
		Clip clip;
		const std::string fault = read_clip(reader, frames, clip);
		if (!fault.empty()) {
			return fault;
		}
		found.push_back(std::move(clip));
	}
	if (reader.left() != 0) {
		return "the motion set goes on behind its last clip";
	}
	r_clips = std::move(found);
	return "";
}

} // namespace matching
