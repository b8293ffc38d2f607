// SPDX-License-Identifier: MIT
#pragma once

#include "gait/travel.hpp"

namespace ragdoll {

/// Thesis section 8.4.1: the lowest foot point is held where it is; when another one becomes the lowest,
/// that one is held from then on. Level ground, and persons on their feet.
class LowestFoot : public Travel {
public:
	using Travel::Travel;

	bool knows_what_carries() const override { return false; }
	void save(ArchiveWriter &p_archive) const override;
	bool restore(ArchiveReader &p_archive) override;

protected:
	void begin(const GaitInput &p_input) override;
	void advance(const GaitInput &p_input) override;

private:
	int find_lowest(const std::vector<Vec3> &p_points) const;

	int _held = -1; // The thesis's j.
	float _level = 0.0f; // Of the ground, m.
};

} // namespace ragdoll
