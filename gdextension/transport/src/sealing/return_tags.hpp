// SPDX-License-Identifier: MIT
#pragma once

#include "messages.hpp"

#include <map>

namespace transport {

/// Tags of clients that have proven the password of a role: who is gone may come back into that role with
/// its tag, once and for a while, without counting as a try of the password.
class ReturnTags {
public:
	static constexpr int64_t KEPT_USEC = 90000000;
	static constexpr size_t MAX = 8192;

	/// A client is here.
	void add(const messages::ReturnTag &p_tag, uint8_t p_role) {
		if (_tags.size() < MAX) {
			_tags[p_tag] = { p_role, INT64_MAX };
		}
	}

	/// A client is gone.
	void leave(const messages::ReturnTag &p_tag, int64_t p_now_usec) {
		const auto found = _tags.find(p_tag);
		if (found != _tags.end()) {
			found->second.until_usec = p_now_usec + KEPT_USEC;
		}
	}

	/// Whether a tag is good for a role; it is good once.
	bool take(const messages::ReturnTag &p_tag, uint8_t p_role, int64_t p_now_usec) {
		const auto found = _tags.find(p_tag);
		const bool good = found != _tags.end() && found->second.role == p_role && found->second.until_usec > p_now_usec;
		if (good) {
			_tags.erase(found);
		}
		return good;
	}

	/// The passwords are others: who has proven an old one has proven nothing.
	void clear() { _tags.clear(); }

	/// Forgets those whose time is over.
	void look_after(int64_t p_now_usec) {
		for (auto tag = _tags.begin(); tag != _tags.end();) {
			tag = tag->second.until_usec < p_now_usec ? _tags.erase(tag) : std::next(tag);
		}
	}

private:
	struct Good {
		uint8_t role = 0;
		int64_t until_usec = 0;
	};

	std::map<messages::ReturnTag, Good> _tags;
};

} // namespace transport
