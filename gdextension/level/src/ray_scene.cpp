// SPDX-License-Identifier: MIT
#include "ray_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace level {

namespace {

constexpr uint32_t LEAF_SIZE = 4;
constexpr int BINS = 12;
constexpr int MAX_DEPTH = 64;
/// Corners of the triangle itself must not shadow what begins on it.
constexpr float NEAREST = 1e-4f;

float on_axis(const Vec3 &p_vector, int p_axis) {
	return p_axis == 0 ? p_vector.x : (p_axis == 1 ? p_vector.y : p_vector.z);
}

Vec3 least(const Vec3 &p_a, const Vec3 &p_b) {
	return { std::min(p_a.x, p_b.x), std::min(p_a.y, p_b.y), std::min(p_a.z, p_b.z) };
}

Vec3 greatest(const Vec3 &p_a, const Vec3 &p_b) {
	return { std::max(p_a.x, p_b.x), std::max(p_a.y, p_b.y), std::max(p_a.z, p_b.z) };
}

int bin_of(float p_value, float p_low, float p_high) {
	const int bin = int(float(BINS) * (p_value - p_low) / (p_high - p_low));
	return std::clamp(bin, 0, BINS - 1);
}

float inverse(float p_value) {
	return std::fabs(p_value) > 1e-20f ? 1.0f / p_value : std::copysign(1e20f, p_value);
}

} // namespace

struct RayScene::Ray {
	Vec3 from;
	Vec3 way;
	Vec3 inverse_way;
	float farthest = 0.0f;

	/// Distance at which it enters a box, or more than the farthest where it does not.
	float enters(const Box &p_box) const {
		const Vec3 near = (p_box.low - from).scaled(inverse_way);
		const Vec3 far = (p_box.high - from).scaled(inverse_way);
		const Vec3 first = least(near, far);
		const Vec3 last = greatest(near, far);
		const float entry = std::max({ first.x, first.y, first.z, 0.0f });
		const float exit = std::min({ last.x, last.y, last.z, farthest });
		return entry <= exit ? entry : std::numeric_limits<float>::max();
	}
};

void RayScene::Box::include(const Vec3 &p_point) {
	low = least(low, p_point);
	high = greatest(high, p_point);
}

void RayScene::Box::include(const Box &p_other) {
	low = least(low, p_other.low);
	high = greatest(high, p_other.high);
}

float RayScene::Box::area() const {
	const Vec3 size = high - low;
	return size.x < 0.0f ? 0.0f : size.x * size.y + size.y * size.z + size.z * size.x;
}

void RayScene::build(const std::vector<Triangle> &p_triangles) {
	_nodes.clear();
	_triangles.clear();
	_boxes.assign(p_triangles.size(), Box());
	_order.clear();
	for (std::size_t number = 0; number < p_triangles.size(); number++) {
		const Triangle &triangle = p_triangles[number];
		const float area = triangle.normal().length();
		if (!(area > 1e-12f) || !std::isfinite(area)) {
			continue;
		}
		Box &box = _boxes[number];
		box.include(triangle.a);
		box.include(triangle.b);
		box.include(triangle.c);
		_order.push_back(uint32_t(number));
	}
	if (!_order.empty()) {
		_nodes.reserve(_order.size());
		_nodes.emplace_back();
		divide(0, 0, uint32_t(_order.size()));
	}
	_triangles.reserve(_order.size());
	for (const uint32_t number : _order) {
		const Triangle &triangle = p_triangles[number];
		_triangles.push_back({ triangle.a, triangle.b - triangle.a, triangle.c - triangle.a, number });
	}
	_boxes = {};
	_order = {};
}

RayScene::Split RayScene::find_split(uint32_t p_first, uint32_t p_count, const Box &p_centres) const {
	Split best;
	for (int axis = 0; axis < 3; axis++) {
		const float low = on_axis(p_centres.low, axis);
		const float high = on_axis(p_centres.high, axis);
		if (!(high - low > 1e-6f)) {
			continue;
		}
		std::array<Box, BINS> boxes;
		std::array<uint32_t, BINS> counts{};
		for (uint32_t index = p_first; index < p_first + p_count; index++) {
			const Box &box = _boxes[_order[index]];
			const int bin = bin_of(on_axis(box.low + box.high, axis) * 0.5f, low, high);
			boxes[bin].include(box);
			counts[bin]++;
		}
		std::array<float, BINS> behind{};
		Box right;
		uint32_t right_count = 0;
		for (int bin = BINS - 1; bin > 0; bin--) {
			right.include(boxes[bin]);
			right_count += counts[bin];
			behind[bin] = right.area() * float(right_count);
		}
		Box left;
		uint32_t left_count = 0;
		for (int bin = 1; bin < BINS; bin++) {
			left.include(boxes[bin - 1]);
			left_count += counts[bin - 1];
			const float cost = left.area() * float(left_count) + behind[bin];
			if (left_count > 0 && left_count < p_count && cost < best.cost) {
				best = { axis, bin, cost };
			}
		}
	}
	return best;
}

uint32_t RayScene::partition(uint32_t p_first, uint32_t p_count, const Box &p_centres, const Split &p_split) {
	const float low = on_axis(p_centres.low, p_split.axis);
	const float high = on_axis(p_centres.high, p_split.axis);
	const auto begin = _order.begin() + p_first;
	const auto middle = std::partition(begin, begin + p_count, [&](uint32_t p_number) {
		const Box &box = _boxes[p_number];
		return bin_of(on_axis(box.low + box.high, p_split.axis) * 0.5f, low, high) < p_split.bin;
	});
	return uint32_t(middle - begin);
}

void RayScene::divide(uint32_t p_node, uint32_t p_first, uint32_t p_count) {
	struct Task {
		uint32_t node;
		uint32_t first;
		uint32_t count;
		int depth;
	};
	std::vector<Task> tasks{ { p_node, p_first, p_count, 0 } };
	while (!tasks.empty()) {
		const Task task = tasks.back();
		tasks.pop_back();
		Box box;
		Box centres;
		for (uint32_t index = task.first; index < task.first + task.count; index++) {
			const Box &each = _boxes[_order[index]];
			box.include(each);
			centres.include((each.low + each.high) * 0.5f);
		}
		_nodes[task.node].box = box;
		const Split split = task.count > LEAF_SIZE && task.depth < MAX_DEPTH - 2
				? find_split(task.first, task.count, centres)
				: Split();
		if (split.axis < 0) {
			_nodes[task.node].first = task.first;
			_nodes[task.node].count = task.count;
			continue;
		}
		const uint32_t left = partition(task.first, task.count, centres, split);
		const auto child = uint32_t(_nodes.size());
		_nodes.emplace_back();
		_nodes.emplace_back();
		_nodes[task.node].first = child;
		tasks.push_back({ child, task.first, left, task.depth + 1 });
		tasks.push_back({ child + 1, task.first + left, task.count - left, task.depth + 1 });
	}
}

template <bool t_any>
bool RayScene::trace(Ray &p_ray, Hit &r_hit) const {
	if (_nodes.empty()) {
		return false;
	}
	std::array<uint32_t, MAX_DEPTH + 2> stack{};
	int depth = 0;
	stack[depth++] = 0;
	bool found = false;
	while (depth > 0) {
		const Node &node = _nodes[stack[--depth]];
		if (p_ray.enters(node.box) > p_ray.farthest) {
			continue;
		}
		if (node.count == 0) {
			const float left = p_ray.enters(_nodes[node.first].box);
			const float right = p_ray.enters(_nodes[node.first + 1].box);
			// The nearer one last, as it is taken first.
			const uint32_t nearer = left <= right ? node.first : node.first + 1;
			const uint32_t farther = left <= right ? node.first + 1 : node.first;
			if (std::max(left, right) <= p_ray.farthest) {
				stack[depth++] = farther;
			}
			if (std::min(left, right) <= p_ray.farthest) {
				stack[depth++] = nearer;
			}
			continue;
		}
		for (uint32_t index = node.first; index < node.first + node.count; index++) {
			// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
			const Prepared &triangle = _triangles[index];
			const Vec3 across = p_ray.way.cross(triangle.to_c);
			const float scale = triangle.to_b.dot(across);
			if (std::fabs(scale) < 1e-12f) {
				continue;
			}
			const float by = 1.0f / scale;
			const Vec3 from = p_ray.from - triangle.corner;
			const float u = from.dot(across) * by;
			const Vec3 other = from.cross(triangle.to_b);
			const float v = p_ray.way.dot(other) * by;
			const float distance = triangle.to_c.dot(other) * by;
			if (u < 0.0f || v < 0.0f || u + v > 1.0f || distance < NEAREST || distance >= p_ray.farthest) {
				continue;
			}
			if (t_any) {
				return true;
			}
			found = true;
			p_ray.farthest = distance;
			// Corners run clockwise, so the sign is the other way round than in the paper.
			r_hit = { triangle.number, distance, scale > 0.0f };
		}
	}
	return found;
}

Hit RayScene::closest(const Vec3 &p_from, const Vec3 &p_way, float p_farthest) const {
	Hit hit;
	Ray ray{ p_from, p_way, { inverse(p_way.x), inverse(p_way.y), inverse(p_way.z) }, p_farthest };
	trace<false>(ray, hit);
	return hit;
}

bool RayScene::is_blocked(const Vec3 &p_from, const Vec3 &p_to) const {
	const Vec3 way = p_to - p_from;
	Hit hit;
	Ray ray{ p_from, way, { inverse(way.x), inverse(way.y), inverse(way.z) }, 1.0f - NEAREST };
	return trace<true>(ray, hit);
}

} // namespace level
