// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace level {

/// Shares out work to threads, and says how far it is.
class Workers {
public:
	/// p_progress is set to how far all the work is, 0 to 1.
	Workers(int p_threads, std::atomic<float> &p_progress) :
			_threads(std::clamp(p_threads, 1, 64)), _progress(p_progress) {}

	/// Runs p_work(first, last) on ranges that together are 0 to p_count. What is done goes from p_from to
	/// p_to meanwhile.
	template <typename t_work>
	void share_out(std::size_t p_count, float p_from, float p_to, const t_work &p_work) const {
		std::atomic<std::size_t> next{ 0 };
		const auto run = [&]() {
			while (true) {
				const std::size_t first = next.fetch_add(BATCH);
				if (first >= p_count) {
					return;
				}
				p_work(first, std::min(first + BATCH, p_count));
				_progress.store(p_from + (p_to - p_from) * float(first) / float(p_count), std::memory_order_relaxed);
			}
		};
		std::vector<std::thread> others;
		for (int number = 1; number < _threads; number++) {
			others.emplace_back(run);
		}
		run();
		for (std::thread &other : others) {
			other.join();
		}
	}

private:
	static constexpr std::size_t BATCH = 64;

	int _threads;
	std::atomic<float> &_progress;
};

} // namespace level
