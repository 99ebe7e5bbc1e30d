mkgrid --image "$DATA/images/worm.png" --cells 4 --lattice 32
