// An angle bracket with two holes for screws and a hole in its wall, in millimeters.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 60, 40, 8};
Box(2) = {0, 0, 0, 8, 40, 56};
Cylinder(3) = {44, 10, 0, 0, 0, 8, 4};
Cylinder(4) = {44, 30, 0, 0, 0, 8, 4};
Cylinder(5) = {0, 20, 36, 8, 0, 0, 10};
BooleanUnion(6) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(7) = { Volume{6}; Delete; }{ Volume{3:5}; Delete; };
Physical Volume("steel") = {7};
screws() = Surface In BoundingBox {39, 5, -1, 49, 35, 9};
wall() = Surface In BoundingBox {7, -1, 7, 9, 41, 57};
rest() = Surface{:};
rest() -= {screws(), wall()};
Physical Surface("screws") = {screws()};
Physical Surface("wall") = {wall()};
Physical Surface("rest") = {rest()};
Mesh.MeshSizeMax = 3;
