// SPDX-License-Identifier: MIT
#pragma once

#include <impact_detector.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <unordered_map>
#include <vector>

namespace godot {

/// Finds what strikes what and what scrapes along what. Documented in doc_classes/ImpactWatch.xml.
class ImpactWatch : public RefCounted {
	GDCLASS(ImpactWatch, RefCounted)

public:
	void watch(int64_t p_entity, const RID &p_body, int64_t p_group);
	void forget(int64_t p_entity);
	void clear();
	int64_t advance();

	int64_t get_entity(int64_t p_impact) const;
	int64_t get_other_entity(int64_t p_impact) const;
	int64_t get_other_instance(int64_t p_impact) const;
	Vector3 get_place(int64_t p_impact) const;
	double get_impulse(int64_t p_impact) const;
	double get_slip(int64_t p_impact) const;

protected:
	static void _bind_methods();

private:
	struct Watched {
		RID body;
		int64_t entity = 0;
		int64_t group = 0;
	};
	/// What the server says of a contact that may become an impact.
	struct Place {
		Vector3 point;
		int64_t entity = 0;
		int64_t other = -1;
		int64_t instance = 0;
	};
	struct Found {
		contact::Impact impact;
		Place place;
	};

	void _read(const Watched &p_watched);
	void _add(const Watched &p_watched, PhysicsDirectBodyState3D &r_state, int p_contact, float p_mass);
	bool _has(int64_t p_impact) const { return p_impact >= 0 && p_impact < int64_t(_found.size()); }

	contact::ImpactDetector _detector;
	std::vector<Watched> _bodies;
	/// Positions in _bodies by the number of the body's RID.
	std::unordered_map<std::uint64_t, std::size_t> _by_body;
	std::vector<contact::Touch> _touches;
	std::vector<Place> _places;
	std::vector<Found> _found;
};

} // namespace godot
