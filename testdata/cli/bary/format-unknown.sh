bary --format stl m.stl g
