// SPDX-License-Identifier: MIT
#pragma once

#include "cell_grid.hpp"
#include "part_surfaces.hpp"
#include "ray_scene.hpp"
#include "visibility_dice.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace level {

/// Which parts of a level, and which cells, can be seen from each cell: potentially visible sets
/// (thesis section 4.2.2).
///
/// Rays start at points of cells and at points of parts. What a ray meets is seen from every cell that
/// it has crossed: so each ray looks for dozens of cells. Sets of parts have smaller cells than sight
/// between cells: a step to the side shows little that is new.
class Visibility {
public:
	/// Cells of the sets of parts along the edge of a cell.
	int divisions = 2;
	/// Points in each of these small cells from which is looked, where somebody can stand and elsewhere.
	int eyes = 8;
	int eyes_aloft = 4;
	/// Rays from each of them to all sides.
	int shower = 130;
	/// Edge of the cubes into which parts are divided, m; rays from each of these cubes to all sides, and
	/// from each part at least.
	float cluster_m = 3.0f;
	int cluster_rays = 600;
	int part_rays = 40000;
	/// A ray that finds something new is followed by so many others close to it, and those that find more by
	/// others again, so many at most for a small cell: what is seen through a gap is found whole.
	int followers = 3;
	int most_followers = 20000;
	/// Rays to a part that a neighbouring cell sees and this one has not yet seen, and how often that is
	/// done: what is just above a skyline is found so.
	int confirming = 40;
	int rounds = 2;
	/// Rays to each cell from each.
	int cell_tries = 4;
	/// How far anything is seen, m.
	float farthest = 250.0f;
	/// Threads that work.
	int threads = 2;

	/// p_part_of has the part of each triangle of the scene; -1 for what only hides.
	Visibility(const RayScene &p_scene, const std::vector<Triangle> &p_triangles, const std::vector<int32_t> &p_part_of,
			int p_parts, const CellGrid &p_grid);
	/// Works it out.
	void survey();
	/// The small cells: see divisions.
	const CellGrid &small_cells() const { return _small; }
	/// A byte for each small cell and part (part fastest): 1 if some of the part is seen from the cell.
	const std::vector<uint8_t> &parts() const { return _part_seen; }
	/// A byte for each pair of cells (from, to): 1 if some of the one is seen from the other.
	const std::vector<uint8_t> &cells() const { return _cell_seen; }
	/// A byte for each cell: 1 if there is air in it.
	const std::vector<uint8_t> &open() const { return _open; }
	/// Share of the work that is done, 0 to 1; may be read by another thread.
	float progress() const { return _progress.load(std::memory_order_relaxed); }

private:
	/// A ray that has found something: where it began and ended.
	struct Sight {
		Vec3 from;
		Vec3 to;
	};
	/// What was found from a cell: parts in cubes of the world, rays to be followed, how far the last one went.
	struct Finds {
		std::unordered_set<uint64_t> known;
		std::vector<Sight> sights;
		float length = 0.0f;
	};
	/// Marks that several threads set and none takes away.
	using Marks = std::vector<std::atomic<uint8_t>>;

	void choose_eyes(std::size_t p_first, std::size_t p_last);
	void look(std::size_t p_first, std::size_t p_last);
	void look_out(std::size_t p_first, std::size_t p_last);
	void look_at_cells(std::size_t p_first, std::size_t p_last);
	void note_crossed(std::size_t p_cell, const Vec3 &p_from, const Vec3 &p_to);
	void note_part(int p_part, const Vec3 &p_from, const Vec3 &p_to);
	void look_along(const Vec3 &p_eye, const Vec3 &p_way, Finds &r_finds);
	void follow(Finds &r_finds, VisibilityDice &r_dice);
	void gather_points();
	bool has_floor(const Vec3 &p_point) const;
	void confirm(std::size_t p_first, std::size_t p_last);
	void confirm_part(std::size_t p_cell, int p_part, VisibilityDice &r_dice);
	void widen(std::size_t p_first, std::size_t p_last);
	bool looks_into(std::size_t p_cell, std::size_t p_other) const;
	std::size_t large_of(std::size_t p_small) const;
	void finish();
	bool is_inside(const Vec3 &p_point) const;

	const RayScene &_scene;
	const std::vector<Triangle> &_triangles;
	const std::vector<int32_t> &_part_of;
	int _parts;
	CellGrid _grid;
	CellGrid _small;
	PartSurfaces _surfaces;
	/// Points in the air of each small cell.
	std::vector<std::vector<Vec3>> _eyes;
	/// The same of each cell.
	std::vector<std::vector<Vec3>> _points;
	/// Of each part in turn a byte for each small cell: rays go through neighbouring cells.
	Marks _part_marks;
	/// The same before what is being confirmed: the outcome is that of any order of the threads.
	std::vector<uint8_t> _known;
	Marks _cell_marks;
	std::vector<uint8_t> _part_seen;
	std::vector<uint8_t> _cell_seen;
	std::vector<uint8_t> _open;
	std::atomic<float> _progress{ 0.0f };
};

} // namespace level
