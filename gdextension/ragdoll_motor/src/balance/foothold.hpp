// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "world/ground.hpp"

namespace ragdoll {

/// Parameters of footholds. Found by `bench ground --scene=gaits` on five gaits and `--scene=crates` on twelve, at
/// eight moments each, one at a time. Through crates 73 of 88 walks come far enough, with the foot raised over firm
/// things alone and 12 cm onto loose ones 44. What keeps hips down is LooseGround's.
struct FootholdSettings {
	/// How fast a foot is raised and lowered to the ground, m/s, and how much faster one in the air is raised for each
	/// metre that what does not give way is higher, 1/s: without it, who walks up stairs strikes the treads.
	float speed = 2.0f;
	float faster = 10.0f;
	/// How high over a riser and the ground before it a foot in the air is carried, m. Of 20 walks onto a kerb, five
	/// gaits at four moments, 10 miss 95 % of their way without, 3 with 0.03, 5 with 0.06. On level ground and slopes
	/// it would only cost: feet land late.
	float clearance = 0.03f;
	/// The same over loose things, which lie askew. Of 84 walks of 12 gaits through crates 13 come too short of their
	/// way and 12 fall with 0.15, 9 and 9 with 0.2; with 0.1, of 68 others, 6 more are too short and 7 more fall.
	float loose_clearance = 0.2f;
	/// How much higher than the body's own place a foot is put at most, m: two treads of a stair.
	float climb = 0.5f;
	/// Loose things that are higher than this over firm ground are kicked aside instead of stepped onto, m (with 0.2
	/// and less people are stuck before heaps), and how much of it the body itself rises, m: the legs bend for the
	/// rest.
	float loose_climb = 0.45f;
	float loose_rise = 0.1f;
};

/// Where a foot is about to be, world axes.
struct FootPlace {
	Vec3 ankle; ///< m
	Vec3 ball; ///< From the ankle, level, m.
	Vec3 further; ///< How far it goes until its toes have to clear what is there, level, m.
	float sole = 0.0f; ///< Height of its sole where the motion has it, m.
	float toes = 0.0f; ///< The same of its ball, m.
	float body = 0.0f; ///< How much higher than the motion the body is, m.
	bool is_up = false; ///< It is in the air.
};

/// What is under a foot, and how much higher than in the motion the foot has to be for that.
class Foothold {
public:
	/// The body has been put somewhere: the foot is so much higher than in the motion, m.
	void begin(float p_height);
	/// Looks at the ground, where that is due, and moves the foot to its height.
	void advance(const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place, float p_delta_s);

	/// How much higher than in the motion the foot is put, m.
	float get_height() const { return _height; }
	/// Whether it is over what can be moved.
	bool is_loose() const { return _ground.is_loose; }
	/// The most that the body is to be higher than in the motion for this foot, m.
	float find_rise(const FootholdSettings &p_settings) const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	void look(const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place);
	/// Finds what a foot in the air would strike next, and how much higher it has to be to clear it.
	/// @param p_ahead what is under its ball
	void look_ahead(const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place,
			const Footing &p_ahead);

	/// Calls with each field that is saved: what lies between them is not the same every time.
	template <class HoldType, class Call>
	static void for_each_saved(HoldType &r_hold, const Call &p_call) {
		p_call(r_hold._height);
		p_call(r_hold._firm);
		p_call(r_hold._step);
		p_call(r_hold._looked);
		p_call(r_hold._age_s);
		p_call(r_hold._ground.height);
		p_call(r_hold._ground.is_loose);
		p_call(r_hold._ground.velocity);
		p_call(r_hold._ground.turning);
		p_call(r_hold._ground.pivot);
	}

	float _height = 0.0f; // m
	float _firm = 0.0f; // The same of what does not give way and was stood on last, m.
	float _step = -1e9f; // How much higher it has to be to clear what is in its way, m.
	Vec3 _looked; // Where the ground was looked for, m.
	Footing _ground; // What is there.
	float _age_s = 1e9f; // Since it was looked for.
};

} // namespace ragdoll
