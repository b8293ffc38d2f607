// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"

namespace ragdoll {

/// Lets the motion's position give in where something is in the body's way, and brings it back as soon as nothing
/// is. However far the motion is, the root is pulled by REST or one step of coming back only, so that nothing is
/// pressed through a wall. When to use it: in the modes that pull the root to a known position (is_tethered()).
///
/// Level only: the height is the motion's.
class Tether {
public:
	/// How far a body that is not pulled back may be off before the motion's position gives in, m: more than it is in
	/// any motion without contacts (0.06 in a run), and than a person yields who is brushed in passing.
	static constexpr float SLACK = 0.1f;
	/// How far the body remains off while something holds it, m: the root goes on pulling a little, to slide along what
	/// is in its way.
	static constexpr float REST = 0.03f;
	/// It comes back with BACK (1/s) times its length, with SLOWEST (m/s) at least, and with FAST (m/s) at most as
	/// long as something may be in the way. FAST is faster than people walk: a body stays where it is held until
	/// its wearer is there.
	static constexpr float BACK = 4.0f;
	static constexpr float SLOWEST = 0.25f;
	static constexpr float FAST = 2.0f;
	/// Once nothing is in the way, that limit grows by FASTER (m/s^2) to FASTEST (m/s).
	static constexpr float FASTER = 10.0f;
	static constexpr float FASTEST = 10.0f;

	/// Begins a step.
	/// @param p_off how far the body is from where the last step was to bring it, m
	void advance(const Vec3 &p_off, float p_delta_s);
	/// The body is where it is, whatever the motion says.
	/// @param p_offset from where the motion has the root to the body, m
	void set(const Vec3 &p_offset);
	void clear();

	/// From where the motion has the root to the position that is held instead, m: at the beginning of the
	/// step and at its end.
	const Vec3 &get_now() const { return _now; }
	const Vec3 &get_next() const { return _next; }
	/// Whether something is in the way.
	bool is_held() const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	Vec3 _now; // m
	Vec3 _next; // m
	float _free_s = 1.0f; // Since it was held back.
	float _distance = 0.0f; // How far the body was off, m,
	float _leaving = 0.0f; // how fast that grew, m/s,
	float _pull = 0.0f; // and how fast that has become less, m/s^2.
};

} // namespace ragdoll
