// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace vehicle {

/// A wheel that a track runs around, in the plane of its side: z towards the rear, y up, m.
struct BeltWheel {
	float z = 0.0f;
	float y = 0.0f;
	float radius = 0.0f; ///< Of the line through the links' pins, m.
};

/// Where a link lies: the middle between its two pins.
struct BeltLink {
	float z = 0.0f;
	float y = 0.0f;
	float along_z = 0.0f; ///< Unit vector along the belt: forward on the ground.
	float along_y = 0.0f;
};

/// What a belt is made of.
struct BeltSettings {
	/// Sprocket, road wheels from rear to front, idler, return rollers from front to rear: the belt touches all of
	/// them from outside.
	std::vector<BeltWheel> wheels;
	/// The first wheel whose way to the next one hangs free: the idler.
	size_t first_sagging = 0;
	size_t links = 0;
	float pitch = 0.16f; ///< From pin to pin, m.
	float deepest_sag = 0.12f; ///< What is longer still is drawn with a shorter pitch, m.
};

/// A track laid around its wheels. Its links have a fixed length: what suspension leaves over hangs between the
/// return rollers. Where there is too little or far too much, the pitch gives way.
class Belt {
public:
	/// Takes new settings; returns whether a belt can be laid with them.
	bool configure(const BeltSettings &p_settings);
	/// Moves a wheel by its suspension, m up.
	void set_lift(size_t p_wheel, float p_lift);
	/// Lays the links. p_way is how far the belt has run since it was new, m, forward positive. A link lies at the
	/// sprocket's rearmost point when p_way is a whole number of pitches.
	void lay(double p_way, std::vector<BeltLink> &r_links);
	/// How far the sprocket has turned when the belt has run p_way, rad, forward positive: the same wheel of time.
	double sprocket_angle(double p_way) const;

	size_t link_count() const { return _settings.links; }
	/// Length of the way around the wheels without sag, m.
	float tight_length() const { return _tight; }
	/// From pin to pin as it was laid last, m.
	float drawn_pitch() const { return _pitch; }
	/// How deep the longest free way hangs, m.
	float sag() const { return _sag; }

private:
	/// An arc around a wheel, or a way between two.
	struct Piece {
		float z, y; ///< Middle of an arc, start of a way.
		float radius; ///< 0 for a way.
		float a, b; ///< First angle and turn of an arc; end of a way.
		float sag; ///< Of a way, m.
		float length;
	};

	BeltSettings _settings;
	std::vector<float> _lifts;
	std::vector<float> _angles;
	std::vector<Piece> _pieces;
	float _tight = 0.0f;
	float _pitch = 0.0f;
	float _sag = 0.0f;

	BeltWheel _wheel(size_t p_index) const;
	void _trace();
	void _hang();
	static void _point(const Piece &p_piece, float p_at, float &r_z, float &r_y);
};

} // namespace vehicle
