// SPDX-License-Identifier: MIT
#include <belt.hpp>

#include <algorithm>
#include <cmath>

namespace vehicle {

namespace {

constexpr float TURN = 6.2831853f;
/// An arc that seems to turn nearly once around is one that bends the other way, rad.
constexpr float BENT = -4.5f;

} // namespace

bool Belt::configure(const BeltSettings &p_settings) {
	const size_t count = p_settings.wheels.size();
	_pieces.clear();
	if (count < 3 || p_settings.links < 3 || p_settings.first_sagging >= count || !(p_settings.pitch > 0.0f) ||
			!(p_settings.deepest_sag >= 0.0f)) {
		return false;
	}
	for (size_t i = 0; i < count; i++) {
		const BeltWheel &one = p_settings.wheels[i];
		const BeltWheel &next = p_settings.wheels[(i + 1) % count];
		const float apart = std::hypot(next.z - one.z, next.y - one.y);
		if (!std::isfinite(apart) || !(one.radius > 0.0f) || !(apart > std::fabs(next.radius - one.radius))) {
			return false;
		}
	}
	_settings = p_settings;
	_lifts.assign(count, 0.0f);
	_angles.resize(count);
	_pieces.resize(2 * count);
	_trace();
	_hang();
	return true;
}

void Belt::set_lift(size_t p_wheel, float p_lift) {
	if (p_wheel < _lifts.size() && std::isfinite(p_lift)) {
		_lifts[p_wheel] = p_lift;
	}
}

double Belt::sprocket_angle(double p_way) const {
	return _settings.wheels.empty() ? 0.0 : p_way / double(_settings.wheels[0].radius);
}

BeltWheel Belt::_wheel(size_t p_index) const {
	BeltWheel wheel = _settings.wheels[p_index];
	wheel.y += _lifts[p_index];
	return wheel;
}

void Belt::_trace() {
	const size_t count = _settings.wheels.size();
	for (size_t i = 0; i < count; i++) { // The outer tangent from each wheel to the next, by its normal's angle.
		const BeltWheel one = _wheel(i);
		const BeltWheel next = _wheel((i + 1) % count);
		const float dz = next.z - one.z;
		const float dy = next.y - one.y;
		const float steep = (one.radius - next.radius) / std::sqrt(dz * dz + dy * dy);
		_angles[i] = std::atan2(dy, dz) + std::acos(std::clamp(steep, -1.0f, 1.0f));
	}
	for (size_t i = 0; i < count; i++) {
		const BeltWheel wheel = _wheel(i);
		const float from = _angles[(i + count - 1) % count];
		float turn = _angles[i] - from;
		turn -= TURN * std::ceil((turn - 0.001f) / TURN);
		float reach = wheel.radius;
		float first = from;
		float last = _angles[i];
		if (turn < BENT) { // Over a bump: the two tangents meet just below the wheel.
			const float back = turn + TURN;
			reach /= std::cos(0.5f * back);
			first = last = from + 0.5f * back;
			turn = 0.0f;
		}
		_pieces[2 * i] = { wheel.z, wheel.y, wheel.radius, from, turn, 0.0f, -turn * wheel.radius };
		Piece &way = _pieces[2 * i + 1];
		way.z = wheel.z + reach * std::cos(last);
		way.y = wheel.y + reach * std::sin(last);
		way.radius = way.sag = 0.0f;
		Piece &before = _pieces[(2 * i + 2 * count - 1) % (2 * count)];
		before.a = wheel.z + reach * std::cos(first);
		before.b = wheel.y + reach * std::sin(first);
	}
	_tight = 0.0f;
	for (size_t i = 0; i < count; i++) {
		Piece &way = _pieces[2 * i + 1];
		way.length = std::hypot(way.a - way.z, way.b - way.y);
		_tight += way.length + _pieces[2 * i].length;
	}
}

void Belt::_hang() {
	const size_t count = _settings.wheels.size();
	const float whole = _settings.pitch * float(_settings.links);
	float cubes = 0.0f;
	float longest = 0.0f;
	for (size_t i = _settings.first_sagging; i < count; i++) {
		const float length = _pieces[2 * i + 1].length;
		cubes += length * length * length;
		longest = std::max(longest, length);
	}
	// A free way of length c that hangs by d is longer by 8 d^2 / (3 c); equal pull means that d grows with c^2.
	const float spare = std::max(0.0f, whole - _tight);
	float share = cubes > 0.0f ? std::sqrt(3.0f * spare / (8.0f * cubes)) : 0.0f;
	if (share * longest * longest > _settings.deepest_sag) {
		share = _settings.deepest_sag / (longest * longest);
	}
	_sag = share * longest * longest;
	float length = _tight;
	for (size_t i = _settings.first_sagging; i < count; i++) {
		Piece &way = _pieces[2 * i + 1];
		if (way.length > 1e-6f) {
			way.sag = share * way.length * way.length;
			const float more = 8.0f * way.sag * way.sag / (3.0f * way.length);
			way.length += more;
			length += more;
		}
	}
	_pitch = length / float(_settings.links);
}

void Belt::_point(const Piece &p_piece, float p_at, float &r_z, float &r_y) {
	const float share = p_piece.length > 1e-6f ? p_at / p_piece.length : 0.0f;
	if (p_piece.radius > 0.0f) {
		const float angle = p_piece.a + p_piece.b * share;
		r_z = p_piece.z + p_piece.radius * std::cos(angle);
		r_y = p_piece.y + p_piece.radius * std::sin(angle);
		return;
	}
	r_z = p_piece.z + (p_piece.a - p_piece.z) * share;
	r_y = p_piece.y + (p_piece.b - p_piece.y) * share - 4.0f * p_piece.sag * share * (1.0f - share);
}

void Belt::lay(double p_way, std::vector<BeltLink> &r_links) {
	r_links.resize(_pieces.empty() ? 0 : _settings.links);
	if (r_links.empty()) {
		return;
	}
	_trace();
	_hang();
	const float length = _pitch * float(_settings.links);
	// The phase is a share of a pitch: it must not jump when the pitch is drawn a little longer after a long way.
	const double run = std::isfinite(p_way) ? p_way / double(_settings.pitch) : 0.0;
	const float phase = float(run - std::floor(run));
	// The sprocket is the first arc: its angle 0, straight back, is where links and teeth are in step.
	const Piece &sprocket = _pieces[0];
	float angle = sprocket.a;
	angle -= TURN * std::floor(angle / TURN);
	float at = angle * sprocket.radius - (phase + 0.5f) * _pitch;
	at += at < 0.0f ? length : 0.0f;
	size_t piece = 0;
	while (at > _pieces[piece].length && piece + 1 < _pieces.size()) {
		at -= _pieces[piece++].length;
	}
	float z0 = 0.0f;
	float y0 = 0.0f;
	_point(_pieces[piece], at, z0, y0);
	for (BeltLink &link : r_links) {
		at += _pitch;
		while (at > _pieces[piece].length) {
			at -= _pieces[piece].length;
			piece = piece + 1 < _pieces.size() ? piece + 1 : 0;
		}
		float z1 = 0.0f;
		float y1 = 0.0f;
		_point(_pieces[piece], at, z1, y1);
		const float dz = z1 - z0;
		const float dy = y1 - y0;
		const float apart = std::max(std::sqrt(dz * dz + dy * dy), 1e-6f);
		link = { 0.5f * (z0 + z1), 0.5f * (y0 + y1), dz / apart, dy / apart };
		z0 = z1;
		y0 = y1;
	}
}

} // namespace vehicle
