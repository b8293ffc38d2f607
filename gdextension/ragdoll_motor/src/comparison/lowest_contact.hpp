// SPDX-License-Identifier: MIT
#pragma once

#include "gait/travel.hpp"

namespace ragdoll {

/// Thesis section 8.4.2: whatever touches the ground is held where it is, be it a foot, a knee, a hand or
/// the back, on ground of any shape. All points within a centimetre of the lowest one hold together.
class LowestContact : public Travel {
public:
	/// Points so little above the lowest one (m) support too.
	static constexpr float TOGETHER = 0.01f;

	using Travel::Travel;

protected:
	void begin(const GaitInput &p_input) override;
	void advance(const GaitInput &p_input) override;

private:
	void hold(const GaitInput &p_input);

	std::vector<float> _heights = std::vector<float>(_contacts.size(), 0.0f); // Root's, if a point touched, m.
};

} // namespace ragdoll
