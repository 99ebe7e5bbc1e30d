# No warning where there is only one preimage.
mkgrid --rect 0,0,4,4 --cells 4x4 | decles-edit -e 'rotate all about 0 0 by 90' >g
printf -- '-1 2\n' | deform-mesh --inverse --any --format xy --digits 12 - g
