// SPDX-License-Identifier: MIT
#include "track_belt.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

namespace godot {

namespace {

/// More links than any vehicle has.
constexpr int64_t MAX_LINKS = 400;

} // namespace

bool TrackBelt::configure(
		const PackedVector3Array &p_wheels, int64_t p_first_sagging, int64_t p_links, double p_pitch, double p_x) {
	ERR_FAIL_COND_V_MSG(p_links < 0 || p_links > MAX_LINKS, false, "A track has at most 400 links.");
	ERR_FAIL_COND_V_MSG(!(p_pitch > 0.0), false, "The pitch of a track is more than 0 m.");
	vehicle::BeltSettings settings;
	for (const Vector3 &wheel : p_wheels) {
		settings.wheels.push_back({ float(wheel.x), float(wheel.y), float(wheel.z) });
	}
	settings.first_sagging = size_t(p_first_sagging < 0 ? 0 : p_first_sagging);
	settings.pitch = float(p_pitch);
	settings.links = p_links == 0 ? 3 : size_t(p_links);
	bool is_laid = _belt.configure(settings);
	if (is_laid && p_links == 0) { // As many as it takes.
		const double needed = double(_belt.tight_length()) / p_pitch;
		is_laid = needed < double(MAX_LINKS);
		settings.links = is_laid ? size_t(needed) + 1 : 3;
		is_laid = is_laid && _belt.configure(settings);
	}
	ERR_FAIL_COND_V_MSG(!is_laid, false,
			"A track needs at least three wheels of (z, y, radius), none of them inside the next, and the number of "
			"the "
			"wheel from which on it hangs free.");
	_buffer.resize(int64_t(settings.links) * NUMBERS);
	float *rows = _buffer.ptrw();
	for (int64_t i = 0; i < int64_t(settings.links); i++) {
		float *row = rows + i * NUMBERS;
		for (int k = 0; k < NUMBERS; k++) {
			row[k] = 0.0f;
		}
		row[0] = 1.0f;
		row[3] = float(p_x);
	}
	lay(0.0, PackedFloat32Array());
	return true;
}

void TrackBelt::lay(double p_way, const PackedFloat32Array &p_lifts) {
	for (int64_t i = 0; i < p_lifts.size(); i++) {
		_belt.set_lift(size_t(i) + 1, p_lifts[i]);
	}
	_belt.lay(p_way, _links);
	float *row = _buffer.ptrw();
	for (const vehicle::BeltLink &link : _links) {
		// The link's -Z runs along the belt, its +Y to the inside.
		row[5] = -link.along_z;
		row[6] = -link.along_y;
		row[7] = link.y;
		row[9] = link.along_y;
		row[10] = -link.along_z;
		row[11] = link.z;
		row += NUMBERS;
	}
}

void TrackBelt::show(const RID &p_multimesh) const {
	RenderingServer::get_singleton()->multimesh_set_buffer(p_multimesh, _buffer);
}

PackedVector2Array TrackBelt::get_outline() const {
	PackedVector2Array outline;
	for (const vehicle::BeltLink &link : _links) {
		outline.push_back(Vector2(link.z, link.y));
	}
	return outline;
}

void TrackBelt::_bind_methods() {
	ClassDB::bind_method(
			D_METHOD("configure", "wheels", "first_sagging", "links", "pitch", "x"), &TrackBelt::configure);
	ClassDB::bind_method(D_METHOD("lay", "way", "lifts"), &TrackBelt::lay);
	ClassDB::bind_method(D_METHOD("show", "multimesh"), &TrackBelt::show);
	ClassDB::bind_method(D_METHOD("get_buffer"), &TrackBelt::get_buffer);
	ClassDB::bind_method(D_METHOD("get_outline"), &TrackBelt::get_outline);
	ClassDB::bind_method(D_METHOD("get_link_count"), &TrackBelt::get_link_count);
	ClassDB::bind_method(D_METHOD("get_pitch"), &TrackBelt::get_pitch);
	ClassDB::bind_method(D_METHOD("get_sag"), &TrackBelt::get_sag);
	ClassDB::bind_method(D_METHOD("get_sprocket_angle", "way"), &TrackBelt::get_sprocket_angle);
}

} // namespace godot
