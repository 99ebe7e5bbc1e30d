# nothing: empty, one byte, text, a folder
printf '' | mkgrid --image -
printf 'P' | mkgrid --image -
echo 'hello world' | mkgrid --image -
mkgrid --image "$DATA"
